#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A PostgreSQL server of the tests' own, in a folder of its own under /tmp, reached by a socket there alone.
#   postgresql.sh start FILE       starts one and writes its address into FILE; it ends with the caller, however that ends
#   postgresql.sh stop FILE        ends it and removes all that was its
#   postgresql.sh kill FILE        ends all its processes at once (kill -9), and starts it again
#   postgresql.sh halt FILE        ends it, and keeps all that it has
#   postgresql.sh go FILE          starts what halt ended
#   postgresql.sh pause FILE       it answers nobody any more, and ends no connection
#   postgresql.sh resume FILE      it goes on
#   postgresql.sh run COMMAND...   runs COMMAND with GRIPSCOPE_TEST_SERVER set, as in
#                                  tests/support/postgresql.sh run build/dev/bin/test_core_library LedgerTest
# GRIPSCOPE_SERVER_SETTINGS: further ones, as "-c shared_buffers=1GB"
set -euo pipefail

programs=$(ls -d /usr/lib/postgresql/*/bin 2>/dev/null | sort -V | tail -n 1)
if [ -z "$programs" ]; then
  echo "PostgreSQL is not installed: apt install postgresql" >&2
  exit 1
fi

# PostgreSQL refuses to run as root.
as=()
if [ "$(id -u)" = 0 ]; then
  as=(setpriv --reuid=nobody --regid="$(id -g nobody)" --clear-groups)
fi

end() {
  local folder=$1
  case "$folder" in /tmp/gripscope-postgresql.*) ;; *) return 0 ;; esac
  "${as[@]}" "$programs/pg_ctl" -D "$folder/data" -m immediate -w stop >/dev/null 2>&1 || true
  rm -rf "$folder"
}

# Starts it with the options that it had.
go() {
  "${as[@]}" "$programs/pg_ctl" -D "$(folder_of "$1")/data" -w -l "$(folder_of "$1")/log" restart >/dev/null 2>&1
}

folder_of() {
  sed -n 's/.*host=\([^&]*\).*/\1/p' "$1"
}

begin() {
  folder=$(mktemp -d /tmp/gripscope-postgresql.XXXXXX)
  [ "$(id -u)" = 0 ] && chown nobody "$folder"
  chmod 755 "$folder"
  # Its language orders texts otherwise than by their bytes, as many a server's does. Nothing needs to survive it.
  (cd "$folder" && "${as[@]}" "$programs/initdb" -D "$folder/data" --no-sync -A trust -U gripscope -E UTF8 \
    --locale=C.UTF-8 --locale-provider=icu --icu-locale=de >"$folder.log" 2>&1) || { cat "$folder.log" >&2; exit 1; }
  # One user has to say a password.
  sed -i '1i local all asked_for_a_password scram-sha-256' "$folder/data/pg_hba.conf"
  (cd "$folder" && "${as[@]}" "$programs/pg_ctl" -D "$folder/data" -w -l "$folder/log" -o "-k $folder -F \
    -c listen_addresses='' -c full_page_writes=off -c autovacuum=off -c shared_buffers=64MB -c max_connections=60 ${GRIPSCOPE_SERVER_SETTINGS:-}" \
    start >>"$folder.log" 2>&1) || { cat "$folder.log" "$folder/log" >&2; exit 1; }
  rm -f "$folder.log"
  address="postgresql://gripscope@/postgres?host=$folder&port=5432"
}

# The server must not outlive whoever began it, whatever ends that.
end_with() {
  local caller=$1
  (
    trap '' HUP INT TERM
    while kill -0 "$caller" 2>/dev/null && [ -e "$folder" ]; do sleep 2; done
    end "$folder"
  ) </dev/null >/dev/null 2>&1 &
  disown
}

case "${1:-}" in
start)
  [ -e "$2" ] && end "$(folder_of "$2")" # of a run that was killed
  begin
  echo "$address" >"$2"
  end_with $PPID
  ;;
stop)
  [ -e "$2" ] || exit 0
  end "$(folder_of "$2")"
  rm -f "$2"
  ;;
kill)
  server=$(head -n 1 "$(folder_of "$2")/data/postmaster.pid")
  children=$(pgrep -P "$server" || true)
  kill -KILL "$server" $children 2>/dev/null || true # some ended meanwhile
  while kill -0 "$server" 2>/dev/null; do sleep 0.05; done
  go "$2"
  ;;
halt)
  "${as[@]}" "$programs/pg_ctl" -D "$(folder_of "$2")/data" -m fast -w stop >/dev/null
  ;;
go)
  go "$2"
  ;;
pause | resume)
  server=$(head -n 1 "$(folder_of "$2")/data/postmaster.pid")
  signal=STOP
  [ "$1" = resume ] && signal=CONT
  kill "-$signal" "$server"
  pkill "-$signal" -P "$server" || true # nobody is connected
  ;;
run)
  shift
  begin
  end_with $$
  trap 'end "$folder"' EXIT
  GRIPSCOPE_TEST_SERVER=$address "$@"
  ;;
*)
  sed -n '3,14p' "$0" >&2
  exit 2
  ;;
esac
