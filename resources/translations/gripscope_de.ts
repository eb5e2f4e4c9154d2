<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>CalibrationWords</name>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Not calibrated here: its own scale is taken.</source>
        <translation>Hier nicht kalibriert: Es gilt die eigene Skala.</translation>
    </message>
    <message>
        <source>Overdue since %1: measurements are marked as suspect.</source>
        <translation>Überfällig seit %1: Messungen werden als fraglich markiert.</translation>
    </message>
    <message>
        <source>Holds until %1: calibrate soon.</source>
        <translation>Gilt bis %1: bald kalibrieren.</translation>
    </message>
    <message>
        <source>Holds until %1.</source>
        <translation>Gilt bis %1.</translation>
    </message>
    <message>
        <source>p = %1</source>
        <translation>p = %1</translation>
    </message>
    <message>
        <source>Expanded uncertainty (95 %)</source>
        <translation>Erweiterte Messunsicherheit (95 %)</translation>
    </message>
    <message>
        <source>Linearity</source>
        <translation>Linearität</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>Wiederholbarkeit</translation>
    </message>
    <message>
        <source>Reversibility</source>
        <translation>Umkehrspanne</translation>
    </message>
    <message>
        <source>Zero return</source>
        <translation>Nullpunktrückkehr</translation>
    </message>
    <message>
        <source>Fit of the curve</source>
        <translation>Anpassung der Kurve</translation>
    </message>
    <message>
        <source>reading = %1</source>
        <translation>Anzeige = %1</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>The curve does not follow the points as closely as they repeat: try a higher degree, or look for a point that is wrong.</source>
        <translation>Die Kurve folgt den Punkten nicht so eng, wie sich diese wiederholen: höheren Grad versuchen oder einen falschen Punkt suchen.</translation>
    </message>
    <message>
        <source>force not calibrated</source>
        <translation>Kraft nicht kalibriert</translation>
    </message>
    <message>
        <source>position not calibrated</source>
        <translation>Weg nicht kalibriert</translation>
    </message>
    <message>
        <source>force cal. overdue since %1</source>
        <translation>Kraftkal. überfällig seit %1</translation>
    </message>
    <message>
        <source>position cal. overdue since %1</source>
        <translation>Wegkal. überfällig seit %1</translation>
    </message>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>tomorrow</source>
        <translation>morgen</translation>
    </message>
    <message>
        <source>force cal. due %1</source>
        <translation>Kraftkal. fällig: %1</translation>
    </message>
    <message>
        <source>position cal. due %1</source>
        <translation>Wegkal. fällig: %1</translation>
    </message>
    <message numerus="yes">
        <source>force cal. due in %n days</source>
        <translation>
            <numerusform>Kraftkal. in %n Tag fällig</numerusform>
            <numerusform>Kraftkal. in %n Tagen fällig</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>position cal. due in %n days</source>
        <translation>
            <numerusform>Wegkal. in %n Tag fällig</numerusform>
            <numerusform>Wegkal. in %n Tagen fällig</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CapabilityNumbers</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Pp (percentiles)</source>
        <translation>Pp (Perzentile)</translation>
    </message>
    <message>
        <source>Ppk (percentiles)</source>
        <translation>Ppk (Perzentile)</translation>
    </message>
    <message>
        <source> (Box-Cox)</source>
        <translation> (Box-Cox)</translation>
    </message>
    <message>
        <source>No tolerance limits: type them here, or give the type its own. The histogram shows how the values lie.</source>
        <translation>Keine Toleranzgrenzen: hier tippen oder dem Typ eigene geben. Das Histogramm zeigt, wie die Werte liegen.</translation>
    </message>
    <message>
        <source>Beyond the limits: %1 ppm observed.</source>
        <translation>Jenseits der Grenzen: %1 ppm beobachtet.</translation>
    </message>
    <message>
        <source>Beyond the limits: %1 ppm expected, %2 ppm observed.</source>
        <translation>Jenseits der Grenzen: %1 ppm erwartet, %2 ppm beobachtet.</translation>
    </message>
    <message>
        <source>Too few values to tell whether they are normal.</source>
        <translation>Zu wenige Werte, um zu sagen, ob sie normalverteilt sind.</translation>
    </message>
    <message>
        <source>Nothing speaks against normal values (Anderson-Darling, p %1).</source>
        <translation>Nichts spricht gegen normalverteilte Werte (Anderson-Darling, p %1).</translation>
    </message>
    <message>
        <source>The values are not normal (Anderson-Darling, p %1).</source>
        <translation>Die Werte sind nicht normalverteilt (Anderson-Darling, p %1).</translation>
    </message>
    <message>
        <source>To the power of %1 they are: the indices are of these (Box-Cox).</source>
        <translation>Mit der Potenz %1 sind sie es: Die Indizes sind von diesen (Box-Cox).</translation>
    </message>
    <message>
        <source>The verdict goes by their percentiles, which need no distribution.</source>
        <translation>Das Urteil folgt ihren Perzentilen, die keine Verteilung brauchen.</translation>
    </message>
</context>
<context>
    <name>ControlSeries</name>
    <message>
        <source>T² of m, b and k together</source>
        <translation>T² von m, b und k zusammen</translation>
    </message>
    <message>
        <source>Moving range of %1</source>
        <translation>Gleitende Spannweite von %1</translation>
    </message>
    <message>
        <source>Range of %1</source>
        <translation>Spannweite von %1</translation>
    </message>
    <message>
        <source>Standard deviation of %1</source>
        <translation>Standardabweichung von %1</translation>
    </message>
    <message>
        <source>Moving average of %1</source>
        <translation>Gleitender Mittelwert von %1</translation>
    </message>
    <message>
        <source>Sums of %1</source>
        <translation>Summen von %1</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>Mittelwert von %1</translation>
    </message>
</context>
<context>
    <name>DriftCharts</name>
    <message>
        <source>Since the enrolment, the last squeezes of each type (change, 95 %)</source>
        <translation>Seit dem Einlernen, die letzten Druckversuche jedes Typs (Änderung, 95 %)</translation>
    </message>
    <message>
        <source>No type has three squeezes since its enrolment.</source>
        <translation>Kein Typ hat drei Druckversuche seit seinem Einlernen.</translation>
    </message>
    <message>
        <source>%1 (%)</source>
        <translation>%1 (%)</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Alle zusammen</translation>
    </message>
    <message>
        <source>%1, squeeze by squeeze (% from the enrolment)</source>
        <translation>%1, Versuch für Versuch (% vom Einlernen)</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>No inspected squeeze of an approved type.</source>
        <translation>Kein geprüfter Druckversuch eines freigegebenen Typs.</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>This gripper against the enrolment: as measured, and adjusted (95 %)</source>
        <translation>Dieser Greifer gegen das Einlernen: wie gemessen und angepasst (95 %)</translation>
    </message>
    <message>
        <source>No squeeze yet.</source>
        <translation>Noch kein Druckversuch.</translation>
    </message>
    <message>
        <source>%1, as measured</source>
        <translation>%1, wie gemessen</translation>
    </message>
    <message>
        <source>%1, adjusted</source>
        <translation>%1, angepasst</translation>
    </message>
    <message>
        <source>The adjustment</source>
        <translation>Die Anpassung</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>%1: the file cannot be read (%2). Check the name and its permissions.</source>
        <translation>%1: Die Datei lässt sich nicht lesen (%2). Namen und Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>%1: the file cannot be written (%2). Check the folder, its permissions and the free space.</source>
        <translation>%1: Die Datei lässt sich nicht schreiben (%2). Ordner, Zugriffsrechte und freien Platz prüfen.</translation>
    </message>
    <message>
        <source>%1: %2; %3</source>
        <translation>%1: %2; %3</translation>
    </message>
    <message>
        <source>%1 is not supported yet.</source>
        <translation>%1 wird noch nicht unterstützt.</translation>
    </message>
    <message>
        <source>No gripper answers at %1. %2</source>
        <translation>Unter %1 antwortet kein Greifer. %2</translation>
    </message>
    <message>
        <source>More than one gripper is connected: %1. Name one of them.</source>
        <translation>Mehr als ein Greifer ist angeschlossen: %1. Einen davon nennen.</translation>
    </message>
    <message>
        <source>The gripper at %1 may not be opened by this user. %2</source>
        <translation>Dieser Benutzer darf den Greifer unter %1 nicht öffnen. %2</translation>
    </message>
    <message>
        <source>The gripper at %1 went away (%2). Check the cable, then connect again.</source>
        <translation>Der Greifer unter %1 ist weg (%2). Kabel prüfen, dann neu verbinden.</translation>
    </message>
    <message>
        <source>The gripper refused to %1: %2.</source>
        <translation>Der Greifer lehnt ab (%1): %2.</translation>
    </message>
    <message>
        <source>The gripper did not %1 within %2 s. Check the cable, then try again.</source>
        <translation>Der Greifer hat nicht innerhalb von %2 s reagiert (%1). Kabel prüfen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>%1 of %2 is above the limit of %3 (%4). Nothing was moved; choose less.</source>
        <translation>%1 von %2 liegt über der Grenze von %3 (%4). Nichts wurde bewegt; kleiner wählen.</translation>
    </message>
    <message>
        <source>The gripper is not armed, so it did not %1. Arm it first.</source>
        <translation>Der Greifer ist nicht scharfgeschaltet und tut daher nichts (%1). Erst scharf schalten.</translation>
    </message>
    <message>
        <source>The library %1 cannot be opened (%2).</source>
        <translation>Die Bibliothek %1 lässt sich nicht öffnen (%2).</translation>
    </message>
    <message>
        <source>The library could not %1 (%2). Nothing of it was stored.</source>
        <translation>Die Bibliothek konnte dies nicht: %1 (%2). Nichts davon wurde gespeichert.</translation>
    </message>
    <message>
        <source>The library %1 has version %2; this program knows up to %3. Use a newer program; the library was not changed.</source>
        <translation>Die Bibliothek %1 hat Version %2; dieses Programm kennt bis zu %3. Ein neueres Programm verwenden; die Bibliothek wurde nicht verändert.</translation>
    </message>
    <message>
        <source>%1 is damaged in the library (%2). Restore it from a copy.</source>
        <translation>In der Bibliothek ist etwas beschädigt: %1 (%2). Aus einer Kopie wiederherstellen.</translation>
    </message>
    <message>
        <source>There is no %1.</source>
        <translation>Nicht vorhanden: %1.</translation>
    </message>
    <message>
        <source>The units are %1, but %2 are needed. Name the units of the channels, or use another library.</source>
        <translation>Die Einheiten sind %1, nötig sind aber %2. Die Einheiten der Kanäle angeben oder eine andere Bibliothek verwenden.</translation>
    </message>
    <message>
        <source>%1 was cancelled.</source>
        <translation>Abgebrochen: %1.</translation>
    </message>
    <message>
        <source>The gripper was not armed: %1.</source>
        <translation>Der Greifer wurde nicht scharf geschaltet: %1.</translation>
    </message>
    <message>
        <source>The gripper was stopped: %1.</source>
        <translation>Der Greifer wurde angehalten: %1.</translation>
    </message>
    <message>
        <source>The gripper did not obey Stop. Switch off its power.</source>
        <translation>Der Greifer hat STOPP nicht befolgt. Seine Stromversorgung abschalten.</translation>
    </message>
    <message>
        <source>Whether the library did %1 is not known (%2). Look whether it is there before you do it again.</source>
        <translation>Ob die Bibliothek dies tat, ist nicht bekannt: %1 (%2). Sehen Sie nach, ob es da ist, bevor Sie es noch einmal tun.</translation>
    </message>
</context>
<context>
    <name>GripperTexts</name>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>Empty gripper</source>
        <translation>Leerer Greifer</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Noise of the force</source>
        <translation>Rauschen der Kraft</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Gestell</translation>
    </message>
    <message>
        <source>Lag of the position</source>
        <translation>Zeitversatz des Wegs</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>Zeitversatz</translation>
    </message>
</context>
<context>
    <name>InspectHint</name>
    <message>
        <source>Squeezing…</source>
        <translation>Drückt…</translation>
    </message>
    <message>
        <source>Esc or STOP ends it at once</source>
        <translation>Esc oder STOPP beendet ihn sofort</translation>
    </message>
    <message>
        <source>Judging…</source>
        <translation>Wird beurteilt…</translation>
    </message>
    <message>
        <source>Reading the library…</source>
        <translation>Die Bibliothek wird gelesen…</translation>
    </message>
    <message>
        <source>No types yet</source>
        <translation>Noch keine Typen</translation>
    </message>
    <message>
        <source>Enroll at least one type (Ctrl+3), then inspect parts</source>
        <translation>Mindestens einen Typ einlernen (Strg+3), dann Teile prüfen</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Nicht scharf</translation>
    </message>
    <message>
        <source>Place the part, hands clear, then arm the gripper</source>
        <translation>Teil einlegen, Hände weg, dann scharf schalten</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Place the part, then squeeze: %1</source>
        <translation>Teil einlegen, dann drücken: %1</translation>
    </message>
    <message>
        <source>No type is called or coded “%1”</source>
        <translation>Kein Typ heißt oder hat den Code „%1“</translation>
    </message>
    <message>
        <source>Nothing is expected, as before</source>
        <translation>Nichts wird erwartet, wie zuvor</translation>
    </message>
    <message>
        <source>%1 is expected, as before</source>
        <translation>%1 wird erwartet, wie zuvor</translation>
    </message>
    <message>
        <source>Nothing expected</source>
        <translation>Nichts erwartet</translation>
    </message>
    <message>
        <source>The next part may be any enrolled type</source>
        <translation>Das nächste Teil darf jeder eingelernte Typ sein</translation>
    </message>
    <message>
        <source>is expected from the next part on</source>
        <translation>wird ab dem nächsten Teil erwartet</translation>
    </message>
    <message>
        <source>Not ready to squeeze</source>
        <translation>Nicht bereit zum Drücken</translation>
    </message>
    <message>
        <source>The gripper&apos;s button squeezes once a gripper is connected and armed here</source>
        <translation>Der Knopf des Greifers drückt, sobald ein Greifer verbunden und hier scharf ist</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>The gripper is not armed. Place the part, hands clear, then arm it</source>
        <translation>Der Greifer ist nicht scharfgeschaltet. Teil einlegen, Hände weg, dann scharf schalten</translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation>Nicht angehalten</translation>
    </message>
    <message>
        <source>The last part: %1, %2</source>
        <translation>Das letzte Teil: %1, %2</translation>
    </message>
    <message>
        <source>No approved type</source>
        <translation>Kein freigegebener Typ</translation>
    </message>
    <message>
        <source>A type is recognised once it is approved: finish its enrolment (Ctrl+3), or ask a supervisor to approve it</source>
        <translation>Ein Typ wird erkannt, sobald er freigegeben ist: sein Einlernen beenden (Strg+3) oder eine Aufsicht um die Freigabe bitten</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Entschärft</translation>
    </message>
</context>
<context>
    <name>InspectionLine</name>
    <message>
        <source>Inspection %1: %2 %3</source>
        <translation>Prüfung %1: %2 %3</translation>
    </message>
    <message>
        <source>voided: %1</source>
        <translation>storniert: %1</translation>
    </message>
</context>
<context>
    <name>LiveSqueezeWords</name>
    <message>
        <source>k  %1
b  %2
m  %3</source>
        <translation>k  %1
b  %2
m  %3</translation>
    </message>
    <message>
        <source>Not enough of the squeeze yet.</source>
        <translation>Noch zu wenig vom Druckversuch.</translation>
    </message>
    <message>
        <source>Stiffness known to %1 so far.</source>
        <translation>Steifigkeit bisher auf %1 bekannt.</translation>
    </message>
    <message>
        <source>Still searching.</source>
        <translation>Wird noch gesucht.</translation>
    </message>
</context>
<context>
    <name>PictureWords</name>
    <message>
        <source>The picture could not be kept as %1.</source>
        <translation>Das Bild konnte nicht als %1 abgelegt werden.</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>it is larger than 100 MB</source>
        <translation>sie ist größer als 100 MB</translation>
    </message>
    <message>
        <source>it is neither a PNG nor a JPEG picture</source>
        <translation>sie ist weder ein PNG- noch ein JPEG-Bild</translation>
    </message>
    <message>
        <source>it is larger than %1 by %1 pixels</source>
        <translation>sie ist größer als %1 mal %1 Pixel</translation>
    </message>
    <message>
        <source>it is damaged (%1)</source>
        <translation>sie ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>There is no picture to paste. Copy one first, or choose a file.</source>
        <translation>Es gibt kein Bild zum Einfügen. Erst eines kopieren oder eine Datei wählen.</translation>
    </message>
</context>
<context>
    <name>ProcessNames</name>
    <message>
        <source>Individuals and moving range</source>
        <translation>Einzelwerte und gleitende Spannweite</translation>
    </message>
    <message>
        <source>Mean and range</source>
        <translation>Mittelwert und Spannweite</translation>
    </message>
    <message>
        <source>Mean and standard deviation</source>
        <translation>Mittelwert und Standardabweichung</translation>
    </message>
    <message>
        <source>Moving average (EWMA)</source>
        <translation>Gleitender Mittelwert (EWMA)</translation>
    </message>
    <message>
        <source>Cumulative sums (CUSUM)</source>
        <translation>Kumulierte Summen (CUSUM)</translation>
    </message>
    <message>
        <source>m, b and k together (T²)</source>
        <translation>m, b und k zusammen (T²)</translation>
    </message>
    <message>
        <source>Western Electric rules</source>
        <translation>Regeln von Western Electric</translation>
    </message>
    <message>
        <source>Nelson&apos;s rules</source>
        <translation>Regeln von Nelson</translation>
    </message>
    <message>
        <source>Limits only</source>
        <translation>Nur Grenzen</translation>
    </message>
    <message>
        <source>Limits from the inspections shown.</source>
        <translation>Grenzen aus den gezeigten Prüfungen.</translation>
    </message>
    <message>
        <source>%1 inspections, %2 to %3</source>
        <translation>%1 Prüfungen, %2 bis %3</translation>
    </message>
    <message>
        <source>Limits from the inspections shown; there are fixed ones, from %1.</source>
        <translation>Grenzen aus den gezeigten Prüfungen; es gibt festgelegte, aus %1.</translation>
    </message>
    <message>
        <source>Limits fixed %1 by %2, from %3.</source>
        <translation>Grenzen am %1 von %2 festgelegt, aus %3.</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>jemand ohne Namen</translation>
    </message>
    <message>
        <source>No inspection matches the filters.</source>
        <translation>Keine Prüfung passt zu den Filtern.</translation>
    </message>
    <message>
        <source>%1 was not determined in any of these inspections.</source>
        <translation>%1 wurde in keiner dieser Prüfungen bestimmt.</translation>
    </message>
    <message>
        <source>%1: %2 inspections; a chart needs at least %3.</source>
        <translation>%1: %2 Prüfungen; eine Karte braucht mindestens %3.</translation>
    </message>
    <message>
        <source>%1 inspections of another station</source>
        <translation>%1 Prüfungen einer anderen Station</translation>
    </message>
</context>
<context>
    <name>ReferenceWords</name>
    <message>
        <source>Mass m</source>
        <translation>Masse m</translation>
    </message>
    <message>
        <source>Damping b</source>
        <translation>Dämpfung b</translation>
    </message>
    <message>
        <source>Stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>measurement not valid</source>
        <translation>Messung ungültig</translation>
    </message>
    <message>
        <source>No reference object yet.</source>
        <translation>Noch kein Referenzobjekt.</translation>
    </message>
    <message>
        <source>No check was made yet, and none is asked for.</source>
        <translation>Noch keine Kontrolle gemacht, und keine wird verlangt.</translation>
    </message>
    <message>
        <source>Failed on %1: measurements are marked as suspect.</source>
        <translation>Am %1 nicht bestanden: Messungen werden als fraglich markiert.</translation>
    </message>
    <message>
        <source>Due since %1: measurements are marked as suspect.</source>
        <translation>Fällig seit %1: Messungen werden als fraglich markiert.</translation>
    </message>
    <message>
        <source>Due, it was never made: measurements are marked as suspect.</source>
        <translation>Fällig, noch nie gemacht: Messungen werden als fraglich markiert.</translation>
    </message>
    <message>
        <source>Passed, and holds until %1.</source>
        <translation>Bestanden, gilt bis %1.</translation>
    </message>
    <message>
        <source>Passed on %1.</source>
        <translation>Bestanden am %1.</translation>
    </message>
    <message>
        <source>spring check failed</source>
        <translation>Federkontrolle nicht bestanden</translation>
    </message>
    <message>
        <source>spring check due</source>
        <translation>Federkontrolle fällig</translation>
    </message>
    <message>
        <source>spring check this hour</source>
        <translation>Federkontrolle in dieser Stunde</translation>
    </message>
    <message>
        <source>spring check %1 h ago</source>
        <translation>Federkontrolle vor %1 h</translation>
    </message>
    <message>
        <source>spring check %1 days ago</source>
        <translation>Federkontrolle vor %1 Tagen</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Its certificate</source>
        <translation>Ihr Zertifikat</translation>
    </message>
    <message>
        <source>%1, within %2 %</source>
        <translation>%1, innerhalb %2 %</translation>
    </message>
    <message>
        <source>A check</source>
        <translation>Eine Kontrolle</translation>
    </message>
    <message>
        <source>Holds for</source>
        <translation>Gilt</translation>
    </message>
    <message numerus="yes">
        <source>%n hours</source>
        <translation>
            <numerusform>%n Stunde</numerusform>
            <numerusform>%n Stunden</numerusform>
        </translation>
    </message>
    <message>
        <source>no check is asked for</source>
        <translation>keine Kontrolle verlangt</translation>
    </message>
    <message>
        <source>%1, En %2</source>
        <translation>%1, En %2</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1: %2 (%3)</translation>
    </message>
    <message>
        <source>Passed: within the tolerance, but off by more than the uncertainties explain. Calibrate soon.</source>
        <translation>Bestanden: innerhalb der Toleranz, aber weiter daneben, als die Unsicherheiten erklären. Bald kalibrieren.</translation>
    </message>
    <message>
        <source>Passed.</source>
        <translation>Bestanden.</translation>
    </message>
    <message>
        <source>Failed: off by more than the tolerance. See that the object sits well and nothing rubs, and check again; then calibrate.</source>
        <translation>Nicht bestanden: weiter daneben als die Toleranz. Prüfen, ob das Objekt gut sitzt und nichts reibt, und erneut kontrollieren; dann kalibrieren.</translation>
    </message>
    <message>
        <source>Not valid: the squeezes do not tell m, b and k well enough for the tolerance. Take more squeezes, or more force.</source>
        <translation>Ungültig: Die Druckversuche bestimmen m, b und k nicht gut genug für die Toleranz. Mehr Druckversuche oder mehr Kraft nehmen.</translation>
    </message>
    <message>
        <source>Not valid, so nothing is said of the gripper: %1</source>
        <translation>Ungültig, also sagt das nichts über den Greifer: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n squeezes of %1</source>
        <translation>
            <numerusform>%n Druckversuch mit %1</numerusform>
            <numerusform>%n Druckversuche mit %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ShiftWords</name>
    <message>
        <source>%1 % (%2 to %3)</source>
        <translation>%1 % (%2 bis %3)</translation>
    </message>
    <message>
        <source>Too few squeezes to say</source>
        <translation>Zu wenige Druckversuche für eine Aussage</translation>
    </message>
    <message>
        <source>Nothing has moved</source>
        <translation>Nichts hat sich verschoben</translation>
    </message>
    <message>
        <source>The force or the position sensor has moved</source>
        <translation>Der Kraft- oder der Wegsensor hat sich verschoben</translation>
    </message>
    <message>
        <source>The fingers have changed</source>
        <translation>Die Finger haben sich geändert</translation>
    </message>
    <message>
        <source>The gripper has moved: sensor or fingers</source>
        <translation>Der Greifer hat sich verschoben: Sensor oder Finger</translation>
    </message>
    <message>
        <source>The product has moved, not the gripper</source>
        <translation>Das Produkt hat sich verschoben, nicht der Greifer</translation>
    </message>
    <message>
        <source>Something has moved: the product or the gripper</source>
        <translation>Etwas hat sich verschoben: das Produkt oder der Greifer</translation>
    </message>
    <message>
        <source>Several types have moved, each in its own way</source>
        <translation>Mehrere Typen haben sich verschoben, jeder auf seine Weise</translation>
    </message>
    <message>
        <source>Inspect parts, with the expected type stated where it is known: three of a type or more.</source>
        <translation>Teile prüfen, mit Angabe des erwarteten Typs, wo er bekannt ist: drei eines Typs oder mehr.</translation>
    </message>
    <message>
        <source>Check the calibration of force and position, and calibrate the one that is off.</source>
        <translation>Die Kalibrierung von Kraft und Weg prüfen und neu kalibrieren, was abweicht.</translation>
    </message>
    <message>
        <source>Look at the fingers, then measure the empty gripper again (its baseline).</source>
        <translation>Die Finger ansehen, dann den leeren Greifer neu messen.</translation>
    </message>
    <message>
        <source>Check the calibration first; where it holds, measure the empty gripper again.</source>
        <translation>Zuerst die Kalibrierung prüfen; wenn sie stimmt, den leeren Greifer neu messen.</translation>
    </message>
    <message>
        <source>Look at the parts of %1 from that inspection on.</source>
        <translation>Die Teile von %1 ab dieser Prüfung ansehen.</translation>
    </message>
    <message>
        <source>Look at the batch %1: parts of %2.</source>
        <translation>Das Los %1 ansehen: Teile von %2.</translation>
    </message>
    <message>
        <source>Squeeze parts of other types too: only they tell the product from the gripper.</source>
        <translation>Auch Teile anderer Typen drücken: Nur sie trennen das Produkt vom Greifer.</translation>
    </message>
    <message>
        <source>Look at the products; enrol again those types that are as they should be.</source>
        <translation>Die Produkte ansehen; die Typen neu einlernen, die so sind, wie sie sein sollen.</translation>
    </message>
    <message>
        <source>Go to Calibrate</source>
        <translation>Zum Kalibrieren</translation>
    </message>
    <message>
        <source>Go to History</source>
        <translation>Zum Verlauf</translation>
    </message>
    <message>
        <source>Go to Enroll</source>
        <translation>Zum Einlernen</translation>
    </message>
    <message>
        <source>Go to Inspect</source>
        <translation>Zum Prüfen</translation>
    </message>
</context>
<context>
    <name>StudyCharts</name>
    <message>
        <source>Components of variation (%)</source>
        <translation>Streuungskomponenten (%)</translation>
    </message>
    <message>
        <source>of variance</source>
        <translation>der Varianz</translation>
    </message>
    <message>
        <source>of study variation</source>
        <translation>der Studienstreuung</translation>
    </message>
    <message>
        <source>%1 by part</source>
        <translation>%1 nach Teil</translation>
    </message>
    <message>
        <source>Part; the line joins the means</source>
        <translation>Teil; die Linie verbindet die Mittelwerte</translation>
    </message>
    <message>
        <source>%1 by operator</source>
        <translation>%1 nach Bediener</translation>
    </message>
    <message>
        <source>This study has no operators of its own.</source>
        <translation>Diese Studie hat keine eigenen Bediener.</translation>
    </message>
    <message>
        <source>Operator; the line joins the means</source>
        <translation>Bediener; die Linie verbindet die Mittelwerte</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Part; lines that cross are parts on which operators disagree</source>
        <translation>Teil; wo sich Linien kreuzen, sind Bediener uneins</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>Wiederholpräzision</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Part × operator</source>
        <translation>Teil × Bediener</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Part × station</source>
        <translation>Teil × Station</translation>
    </message>
    <message>
        <source>Reproducibility</source>
        <translation>Vergleichpräzision</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Messmittel</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>%1: range by operator and part</source>
        <translation>%1: Spannweite nach Bediener und Teil</translation>
    </message>
    <message>
        <source>%1: mean by part and operator</source>
        <translation>%1: Mittelwert nach Teil und Bediener</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Squeezes in their order</source>
        <translation>Druckversuche in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>no bias</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Parts that each rater judges alike, and right (%)</source>
        <translation>Teile, die jeder Prüfer gleich und richtig beurteilt (%)</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>Prüfer</translation>
    </message>
    <message>
        <source>alike each time</source>
        <translation>jedes Mal gleich</translation>
    </message>
    <message>
        <source>right each time</source>
        <translation>jedes Mal richtig</translation>
    </message>
    <message>
        <source>%1, squeeze by squeeze</source>
        <translation>%1, Druckversuch für Druckversuch</translation>
    </message>
    <message>
        <source>%1: bias</source>
        <translation>%1: Abweichung</translation>
    </message>
</context>
<context>
    <name>StudyDueWords</name>
    <message>
        <source>Type-1 study</source>
        <translation>Typ-1-Studie</translation>
    </message>
    <message>
        <source>Gauge study</source>
        <translation>Messmittelstudie</translation>
    </message>
    <message>
        <source>Linearity study</source>
        <translation>Linearitätsstudie</translation>
    </message>
    <message>
        <source>Attribute study</source>
        <translation>Attributive Studie</translation>
    </message>
    <message>
        <source>due</source>
        <translation>fällig</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>nicht verlangt</translation>
    </message>
    <message>
        <source>not to be repeated</source>
        <translation>nicht zu wiederholen</translation>
    </message>
    <message>
        <source>overdue since %1</source>
        <translation>überfällig seit %1</translation>
    </message>
    <message>
        <source>holds until %1: repeat it soon</source>
        <translation>gilt bis %1: bald wiederholen</translation>
    </message>
    <message>
        <source>holds until %1</source>
        <translation>gilt bis %1</translation>
    </message>
    <message>
        <source>type-1 study</source>
        <translation>Typ-1-Studie</translation>
    </message>
    <message>
        <source>gauge study</source>
        <translation>Messmittelstudie</translation>
    </message>
    <message>
        <source>linearity study</source>
        <translation>Linearitätsstudie</translation>
    </message>
    <message>
        <source>attribute study</source>
        <translation>attributive Studie</translation>
    </message>
    <message>
        <source>%1 overdue since %2</source>
        <translation>%1 überfällig seit %2</translation>
    </message>
    <message>
        <source>%1 due %2</source>
        <translation>%1 fällig: %2</translation>
    </message>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>tomorrow</source>
        <translation>morgen</translation>
    </message>
    <message numerus="yes">
        <source>%1 due in %n days</source>
        <translation>
            <numerusform>%1 in %n Tag fällig</numerusform>
            <numerusform>%1 in %n Tagen fällig</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>None of this gripper yet: the Quality page leads through them.</source>
        <translation>Noch keine dieses Greifers: Die Seite Qualität führt hindurch.</translation>
    </message>
    <message>
        <source>Types on another gripper</source>
        <translation>Typen an einem anderen Greifer</translation>
    </message>
</context>
<context>
    <name>StudyNumbers</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>%1: all repeats are equal</source>
        <translation>%1: alle Wiederholungen sind gleich</translation>
    </message>
    <message>
        <source>%1: %2 (95 %: %3 to %4)</source>
        <translation>%1: %2 (95 %: %3 bis %4)</translation>
    </message>
    <message>
        <source>%1: %2 (95 %: %3 or more)</source>
        <translation>%1: %2 (95 %: %3 oder mehr)</translation>
    </message>
    <message>
        <source>Components of variation</source>
        <translation>Streuungskomponenten</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>of variance</source>
        <translation>der Varianz</translation>
    </message>
    <message>
        <source>of study variation</source>
        <translation>der Studienstreuung</translation>
    </message>
    <message>
        <source>of tolerance</source>
        <translation>der Toleranz</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Repeatability (standard deviation)</source>
        <translation>Wiederholpräzision (Standardabweichung)</translation>
    </message>
    <message>
        <source>Share of the tolerance that the scatter takes</source>
        <translation>Anteil der Streuung an der Toleranz</translation>
    </message>
    <message>
        <source>Smallest step between readings</source>
        <translation>Kleinster Schritt zwischen Anzeigen</translation>
    </message>
    <message>
        <source>Bias at each reference</source>
        <translation>Abweichung bei jeder Referenz</translation>
    </message>
    <message>
        <source>Test of no bias</source>
        <translation>Test auf keine Abweichung</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>%1 (95 %: %2 to %3)</source>
        <translation>%1 (95 %: %2 bis %3)</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>Prüfer</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>Prüfer</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Urteile</translation>
    </message>
    <message>
        <source>Parts judged alike each time</source>
        <translation>Teile jedes Mal gleich beurteilt</translation>
    </message>
    <message>
        <source>Parts judged right each time</source>
        <translation>Teile jedes Mal richtig beurteilt</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>Übersehen</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Fehlalarme</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Alle zusammen</translation>
    </message>
    <message>
        <source>combinations of them: more than %1</source>
        <translation>Kombinationen davon: mehr als %1</translation>
    </message>
    <message>
        <source>combinations of them: up to %1</source>
        <translation>Kombinationen davon: bis %1</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>Gauge repeatability and reproducibility</source>
        <translation>Wiederhol- und Vergleichpräzision</translation>
    </message>
    <message>
        <source>Type-1 study</source>
        <translation>Typ-1-Studie</translation>
    </message>
    <message>
        <source>Linearity</source>
        <translation>Linearität</translation>
    </message>
    <message>
        <source>Attribute agreement</source>
        <translation>Übereinstimmung von Urteilen</translation>
    </message>
    <message>
        <source>Does it tell parts apart, and is the scatter due to the gripper or to its operators?</source>
        <translation>Unterscheidet er Teile, und kommt die Streuung vom Greifer oder von den Bedienern?</translation>
    </message>
    <message>
        <source>Does it find the value of one known part, again and again?</source>
        <translation>Findet er immer wieder den Wert eines bekannten Teils?</translation>
    </message>
    <message>
        <source>Is it as right for soft parts as for stiff ones?</source>
        <translation>Ist er bei weichen Teilen so richtig wie bei steifen?</translation>
    </message>
    <message>
        <source>Do people call the same parts good, and are they right?</source>
        <translation>Nennen Personen dieselben Teile gut, und haben sie recht?</translation>
    </message>
    <message>
        <source>unfinished: %1 of %2</source>
        <translation>nicht beendet: %1 von %2</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>aufgegeben</translation>
    </message>
    <message>
        <source>Types on another gripper</source>
        <translation>Typen an einem anderen Greifer</translation>
    </message>
    <message>
        <source>Do types that were enrolled on another gripper serve here, and by which adjustment?</source>
        <translation>Taugen Typen, die an einem anderen Greifer eingelernt wurden, hier, und mit welcher Anpassung?</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>calibration points</source>
        <translation>Kalibrierpunkte</translation>
    </message>
    <message>
        <source>expected a degree from 1 to %1</source>
        <translation>erwartet: ein Grad von 1 bis %1</translation>
    </message>
    <message>
        <source>found a number that is not finite</source>
        <translation>gefunden: eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>expected finite loads and readings</source>
        <translation>erwartet: endliche Lasten und Anzeigen</translation>
    </message>
    <message>
        <source>found %1 points at %2 different loads</source>
        <translation>gefunden: %1 Punkte bei %2 verschiedenen Lasten</translation>
    </message>
    <message>
        <source>degree %1 needs at least %2 points at %3 loads</source>
        <translation>Grad %1 braucht mindestens %2 Punkte bei %3 Lasten</translation>
    </message>
    <message>
        <source>found loads from %1 to %2</source>
        <translation>gefunden: Lasten von %1 bis %2</translation>
    </message>
    <message>
        <source>expected a range that is a number</source>
        <translation>erwartet: ein Bereich, der eine Zahl ist</translation>
    </message>
    <message>
        <source>the numbers are too large or too small</source>
        <translation>die Zahlen sind zu groß oder zu klein</translation>
    </message>
    <message>
        <source>choose other units</source>
        <translation>andere Einheiten wählen</translation>
    </message>
    <message>
        <source>the curve does not only rise or only fall between the least and the largest load</source>
        <translation>die Kurve steigt oder fällt zwischen kleinster und größter Last nicht durchgehend</translation>
    </message>
    <message>
        <source>a reading would belong to two loads: choose a lower degree or look at the points</source>
        <translation>eine Anzeige gehörte zu zwei Lasten: kleineren Grad wählen oder die Punkte ansehen</translation>
    </message>
    <message>
        <source>taken %1 against %2, holds until %3</source>
        <translation>aufgenommen am %1 gegen %2, gilt bis %3</translation>
    </message>
    <message>
        <source>The degree of the curve is %1; it may be 1 to %2.</source>
        <translation>Der Grad der Kurve ist %1; erlaubt sind 1 bis %2.</translation>
    </message>
    <message>
        <source>The loads must be different numbers, the least first.</source>
        <translation>Die Lasten müssen verschiedene Zahlen sein, die kleinste zuerst.</translation>
    </message>
    <message>
        <source>A curve of degree %1 needs at least %2 loads; there are %3.</source>
        <translation>Eine Kurve vom Grad %1 braucht mindestens %2 Lasten; es sind %3.</translation>
    </message>
    <message>
        <source>There are %1 runs; there may be 1 to %2.</source>
        <translation>Es sind %1 Durchgänge; erlaubt sind 1 bis %2.</translation>
    </message>
    <message>
        <source>A curve of degree %1 needs at least %2 points: go down again, or add a run.</source>
        <translation>Eine Kurve vom Grad %1 braucht mindestens %2 Punkte: auch abwärts messen oder einen Durchgang hinzufügen.</translation>
    </message>
    <message>
        <source>A reading is averaged over %1 s; more than 0 and at most %2 s make sense.</source>
        <translation>Eine Anzeige wird über %1 s gemittelt; sinnvoll sind mehr als 0 und höchstens %2 s.</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>die Referenz</translation>
    </message>
    <message>
        <source>found an uncertainty of %1</source>
        <translation>gefunden: eine Unsicherheit von %1</translation>
    </message>
    <message>
        <source>expected zero or more, as its certificate states it</source>
        <translation>erwartet: null oder mehr, wie im Zertifikat angegeben</translation>
    </message>
    <message>
        <source>the curve is nearly level at a load of %1</source>
        <translation>die Kurve ist bei einer Last von %1 fast eben</translation>
    </message>
    <message>
        <source>loads cannot be told there: choose a lower degree or look at the points</source>
        <translation>Lasten sind dort nicht zu unterscheiden: kleineren Grad wählen oder die Punkte ansehen</translation>
    </message>
    <message>
        <source>noise on the position biases m, b and k of an ARX model heavily while its fit still looks good: compare oe</source>
        <translation>Rauschen des Wegs verfälscht m, b und k eines ARX-Modells stark, während sein Fit noch gut aussieht: mit oe vergleichen</translation>
    </message>
    <message>
        <source>the coefficients belong to no object with m, b, k &gt; 0; noise on the position does that</source>
        <translation>die Koeffizienten gehören zu keinem Objekt mit m, b, k &gt; 0; das kommt vom Rauschen des Wegs</translation>
    </message>
    <message>
        <source>there are fewer samples than the model has coefficients; record for longer</source>
        <translation>weniger Abtastwerte, als das Modell Koeffizienten hat; länger aufnehmen</translation>
    </message>
    <message>
        <source>force and position do not determine the coefficients; squeeze with a force that varies</source>
        <translation>Kraft und Weg bestimmen die Koeffizienten nicht; mit veränderlicher Kraft drücken</translation>
    </message>
    <message>
        <source>the coefficients are outside the range of numbers</source>
        <translation>die Koeffizienten liegen außerhalb des Zahlenbereichs</translation>
    </message>
    <message>
        <source>the lag between the channels is known to %1 us</source>
        <translation>der Zeitversatz der Kanäle ist auf %1 µs bekannt</translation>
    </message>
    <message>
        <source>the compliance of frame and fingers is known to %1 % of the object&apos;s</source>
        <translation>die Nachgiebigkeit von Gestell und Fingern ist auf %1 % derjenigen des Objekts bekannt</translation>
    </message>
    <message>
        <source>the residuals ask for %1: m would be %2 % away</source>
        <translation>die Residuen sprechen für %1: m läge %2 % daneben</translation>
    </message>
    <message>
        <source>it is not certain how the force is held between samples: the other way m would be %1 % away</source>
        <translation>es ist nicht sicher, wie die Kraft zwischen den Abtastwerten verläuft: andersherum läge m %1 % daneben</translation>
    </message>
    <message>
        <source>the scales of force and position are known to %1 % and %2 %</source>
        <translation>die Skalen von Kraft und Weg sind auf %1 % und %2 % bekannt</translation>
    </message>
    <message>
        <source>the empty gripper&apos;s own m, b and k, which were taken off</source>
        <translation>m, b und k des leeren Greifers, die abgezogen wurden</translation>
    </message>
    <message>
        <source>the residuals ask for %1</source>
        <translation>die Residuen sprechen für %1</translation>
    </message>
    <message>
        <source>the force explains a part of the residuals that the model does not have</source>
        <translation>die Kraft erklärt einen Teil der Residuen, den das Modell nicht hat</translation>
    </message>
    <message>
        <source>this record does not determine the %1: its standard uncertainty is %2 % of its value</source>
        <translation>diese Aufnahme bestimmt die Größe nicht (%1): Ihre Standardunsicherheit ist %2 % ihres Werts</translation>
    </message>
    <message>
        <source>at least %1 Hz: this record does not tell the mass from zero</source>
        <translation>mindestens %1 Hz: Diese Aufnahme unterscheidet die Masse nicht von null</translation>
    </message>
    <message>
        <source>natural frequency</source>
        <translation>Eigenfrequenz</translation>
    </message>
    <message>
        <source>damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>time constant</source>
        <translation>Zeitkonstante</translation>
    </message>
    <message>
        <source>the damping is critical within its uncertainty, so that two time constants cannot be told apart</source>
        <translation>die Dämpfung ist innerhalb ihrer Unsicherheit kritisch, sodass zwei Zeitkonstanten nicht zu trennen sind</translation>
    </message>
    <message>
        <source>damped frequency</source>
        <translation>gedämpfte Frequenz</translation>
    </message>
    <message>
        <source>decay time</source>
        <translation>Abklingzeit</translation>
    </message>
    <message>
        <source>slow time constant</source>
        <translation>langsame Zeitkonstante</translation>
    </message>
    <message>
        <source>fast time constant</source>
        <translation>schnelle Zeitkonstante</translation>
    </message>
    <message>
        <source>no finite mass explains the position; check the grip and the sensor</source>
        <translation>keine endliche Masse erklärt den Weg; Griff und Sensor prüfen</translation>
    </message>
    <message>
        <source>no finite damping explains the position; check the grip and the sensor</source>
        <translation>keine endliche Dämpfung erklärt den Weg; Griff und Sensor prüfen</translation>
    </message>
    <message>
        <source>no finite stiffness explains the position; check the grip and the sensor</source>
        <translation>keine endliche Steifigkeit erklärt den Weg; Griff und Sensor prüfen</translation>
    </message>
    <message>
        <source>the lag between the channels leaves too few samples</source>
        <translation>der Zeitversatz der Kanäle lässt zu wenige Abtastwerte übrig</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>the search did not settle</source>
        <translation>die Suche ist nicht konvergiert</translation>
    </message>
    <message>
        <source>force and position have different lengths</source>
        <translation>Kraft und Weg sind verschieden lang</translation>
    </message>
    <message>
        <source>the mass cannot be told from zero; excite faster, or sample faster</source>
        <translation>die Masse ist nicht von null zu unterscheiden; schneller anregen oder schneller abtasten</translation>
    </message>
    <message>
        <source>the damping cannot be told from zero; squeeze longer or with more force</source>
        <translation>die Dämpfung ist nicht von null zu unterscheiden; länger oder mit mehr Kraft drücken</translation>
    </message>
    <message>
        <source>the stiffness cannot be told from zero; squeeze longer</source>
        <translation>die Steifigkeit ist nicht von null zu unterscheiden; länger drücken</translation>
    </message>
    <message>
        <source>a constant force does not determine m, b and k together with a free start and offset; squeeze with a force that varies, for instance a pseudo-random binary sequence</source>
        <translation>eine konstante Kraft bestimmt m, b und k nicht zusammen mit freiem Anfang und Nullpunkt; mit veränderlicher Kraft drücken, etwa mit einer pseudozufälligen Binärfolge</translation>
    </message>
    <message>
        <source>the position does not change; check that the fingers hold the object and that the sensor works</source>
        <translation>der Weg ändert sich nicht; prüfen, ob die Finger das Objekt halten und der Sensor arbeitet</translation>
    </message>
    <message>
        <source>the position does not answer the force; check the grip and which column is which</source>
        <translation>der Weg folgt der Kraft nicht; den Griff prüfen und welche Spalte welche ist</translation>
    </message>
    <message>
        <source>the sample time or the lag is not a usable number</source>
        <translation>Abtastzeit oder Zeitversatz ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>the recording holds values that are not finite</source>
        <translation>die Aufnahme enthält Werte, die nicht endlich sind</translation>
    </message>
    <message>
        <source>the squeeze is not told from the empty gripper: with its m, b and k taken off, not all that is left is above zero. Check that the part was between the fingers, and measure the empty gripper again</source>
        <translation>der Druckversuch ist vom leeren Greifer nicht zu unterscheiden: Ohne dessen m, b und k ist nicht alles Übrige größer als null. Prüfen, ob das Teil zwischen den Fingern war, und den leeren Greifer neu messen</translation>
    </message>
    <message>
        <source>m, b or k is outside the range of numbers</source>
        <translation>m, b oder k liegt außerhalb des Zahlenbereichs</translation>
    </message>
    <message>
        <source>the iteration did not settle</source>
        <translation>die Iteration ist nicht konvergiert</translation>
    </message>
    <message>
        <source>there are fewer samples than there are unknowns; record for longer</source>
        <translation>weniger Abtastwerte als Unbekannte; länger aufnehmen</translation>
    </message>
    <message>
        <source>%1 us, known to %2 us</source>
        <translation>%1 µs, bekannt auf %2 µs</translation>
    </message>
    <message>
        <source>a lag of %1; but the other force hold with another lag does as well. Name the hold.</source>
        <translation>ein Zeitversatz von %1; der andere Kraftverlauf mit anderem Zeitversatz passt aber ebenso gut. Den Kraftverlauf angeben.</translation>
    </message>
    <message>
        <source>a lag of %1: too little to tell it from none. Measure it on more squeezes, or on a stiffer object with less noise.</source>
        <translation>ein Zeitversatz von %1: zu wenig, um ihn von keinem zu unterscheiden. An mehr Druckversuchen messen oder an einem steiferen Objekt mit weniger Rauschen.</translation>
    </message>
    <message>
        <source>the position channel samples later than the force channel by %1</source>
        <translation>der Wegkanal tastet später ab als der Kraftkanal, um %1</translation>
    </message>
    <message>
        <source>the data or the options hold numbers that can&apos;t be used</source>
        <translation>die Daten oder Optionen enthalten unbrauchbare Zahlen</translation>
    </message>
    <message>
        <source>no m, b and k could be found, so there is nothing to measure the lag against</source>
        <translation>m, b und k waren nicht zu finden, also gibt es nichts, woran der Zeitversatz zu messen wäre</translation>
    </message>
    <message>
        <source>the best lag, %1 us, lies at the end of what was searched: the object is no mass, spring and damper at this force, or the lag is much larger than expected</source>
        <translation>der beste Zeitversatz, %1 µs, liegt am Rand des Gesuchten: Das Objekt ist bei dieser Kraft nicht Masse, Feder und Dämpfer, oder der Zeitversatz ist viel größer als erwartet</translation>
    </message>
    <message>
        <source>none of the squeezes tells the lag</source>
        <translation>aus keinem der Druckversuche lässt sich der Zeitversatz bestimmen</translation>
    </message>
    <message>
        <source>a further delay between force and position</source>
        <translation>eine weitere Verzögerung zwischen Kraft und Weg</translation>
    </message>
    <message>
        <source>mass, spring and damper</source>
        <translation>Masse, Feder und Dämpfer</translation>
    </message>
    <message>
        <source>a stiffening spring</source>
        <translation>eine versteifende Feder</translation>
    </message>
    <message>
        <source>a softening spring</source>
        <translation>eine erweichende Feder</translation>
    </message>
    <message>
        <source>no offset of the position</source>
        <translation>kein Nullpunktversatz des Wegs</translation>
    </message>
    <message>
        <source>an offset of the position</source>
        <translation>ein Nullpunktversatz des Wegs</translation>
    </message>
    <message>
        <source>a force that is held from sample to sample</source>
        <translation>eine von Abtastwert zu Abtastwert gehaltene Kraft</translation>
    </message>
    <message>
        <source>a force that runs straight from sample to sample</source>
        <translation>eine von Abtastwert zu Abtastwert gerade verlaufende Kraft</translation>
    </message>
    <message>
        <source>a force that is smooth between its samples</source>
        <translation>eine zwischen den Abtastwerten glatte Kraft</translation>
    </message>
    <message>
        <source>The linear model is enough.</source>
        <translation>Das lineare Modell genügt.</translation>
    </message>
    <message>
        <source>%1 explains this squeeze better, but m, b and k stay within their errors: the linear model is enough.</source>
        <translation>%1 erklärt diesen Druckversuch besser, aber m, b und k bleiben innerhalb ihrer Fehler: Das lineare Modell genügt.</translation>
    </message>
    <message>
        <source>%1 explains this squeeze better.</source>
        <translation>%1 erklärt diesen Druckversuch besser.</translation>
    </message>
    <message>
        <source>too few parts determine m, b and k well enough to be compared</source>
        <translation>zu wenige Abschnitte bestimmen m, b und k gut genug für einen Vergleich</translation>
    </message>
    <message>
        <source>%1 parts agree on m, b and k within their noise</source>
        <translation>%1 Abschnitte stimmen in m, b und k innerhalb ihres Rauschens überein</translation>
    </message>
    <message>
        <source>%1 parts disagree beyond their noise by %2 % in m, %3 % in b and %4 % in k</source>
        <translation>%1 Abschnitte weichen über ihr Rauschen hinaus ab, um %2 % in m, %3 % in b und %4 % in k</translation>
    </message>
    <message>
        <source>there is no estimate whose parts could be compared</source>
        <translation>keine Schätzung, deren Abschnitte sich vergleichen ließen</translation>
    </message>
    <message>
        <source>the record is too short to compare parts of it; squeeze longer</source>
        <translation>die Aufnahme ist zu kurz, um Abschnitte zu vergleichen; länger drücken</translation>
    </message>
    <message>
        <source>a spring that stiffens or softens with travel</source>
        <translation>eine Feder, die mit dem Weg versteift oder erweicht</translation>
    </message>
    <message>
        <source>a spring that differs between both directions</source>
        <translation>eine Feder, die in beiden Richtungen verschieden ist</translation>
    </message>
    <message>
        <source>damping that grows with speed</source>
        <translation>Dämpfung, die mit der Geschwindigkeit wächst</translation>
    </message>
    <message>
        <source>dry friction</source>
        <translation>trockene Reibung</translation>
    </message>
    <message>
        <source>a force that is smooth between the samples, not a straight line</source>
        <translation>eine zwischen den Abtastwerten glatte Kraft, keine Gerade</translation>
    </message>
    <message>
        <source>noise of position and force, correlated over time (an autoregressive model of order %1)</source>
        <translation>Rauschen von Weg und Kraft, zeitlich korreliert (autoregressives Modell der Ordnung %1)</translation>
    </message>
    <message>
        <source>white noise of the position</source>
        <translation>weißes Rauschen des Wegs</translation>
    </message>
    <message>
        <source>white noise of the force, as stated or measured before the squeeze</source>
        <translation>weißes Rauschen der Kraft, wie angegeben oder vor dem Druckversuch gemessen</translation>
    </message>
    <message>
        <source>there are fewer samples than output error has unknowns; record for longer</source>
        <translation>weniger Abtastwerte, als das Ausgangsfehlermodell Unbekannte hat; länger aufnehmen</translation>
    </message>
    <message>
        <source>more than half of the samples are lost; check the connection and record again</source>
        <translation>mehr als die Hälfte der Abtastwerte ging verloren; die Verbindung prüfen und neu aufnehmen</translation>
    </message>
    <message>
        <source>converged on %1 periods of %2 samples</source>
        <translation>konvergiert mit %1 Perioden von %2 Abtastwerten</translation>
    </message>
    <message>
        <source>; the misfit is larger than the noise between periods explains, and the errors were enlarged to match</source>
        <translation>; der Modellfehler ist größer, als das Rauschen zwischen den Perioden erklärt, die Fehler wurden entsprechend vergrößert</translation>
    </message>
    <message>
        <source>; harmonics that the force does not have show a nonlinear answer of %1 %</source>
        <translation>; Oberschwingungen, die die Kraft nicht hat, zeigen eine nichtlineare Antwort von %1 %</translation>
    </message>
    <message>
        <source>the force does not repeat four times or more without lost samples; record a periodic excitation, such as inverse-repeat, over at least four periods</source>
        <translation>die Kraft wiederholt sich nicht mindestens viermal ohne verlorene Abtastwerte; eine periodische Anregung wie inverse-repeat über mindestens vier Perioden aufnehmen</translation>
    </message>
    <message>
        <source>there are %1 periods without lost samples, and four are needed; record more periods</source>
        <translation>es gibt %1 Perioden ohne verlorene Abtastwerte, nötig sind vier; mehr Perioden aufnehmen</translation>
    </message>
    <message>
        <source>the force does not repeat after %1 samples over four periods; record a periodic excitation, such as inverse-repeat</source>
        <translation>die Kraft wiederholt sich nicht nach %1 Abtastwerten über vier Perioden; eine periodische Anregung wie inverse-repeat aufnehmen</translation>
    </message>
    <message>
        <source>the search did not settle; record more periods or a stronger excitation</source>
        <translation>die Suche ist nicht konvergiert; mehr Perioden oder eine stärkere Anregung aufnehmen</translation>
    </message>
    <message>
        <source>the lag between the channels leaves too few periods</source>
        <translation>der Zeitversatz der Kanäle lässt zu wenige Perioden übrig</translation>
    </message>
    <message>
        <source>the repeating force has too few frequencies to determine m, b and k; squeeze with a richer one</source>
        <translation>die wiederholte Kraft hat zu wenige Frequenzen, um m, b und k zu bestimmen; mit einer frequenzreicheren drücken</translation>
    </message>
    <message>
        <source>there is no estimate with a covariance to start from</source>
        <translation>keine Schätzung mit Kovarianz, von der auszugehen wäre</translation>
    </message>
    <message>
        <source>what the lag and the frame&apos;s compliance do could not be computed</source>
        <translation>die Wirkung von Zeitversatz und Nachgiebigkeit des Gestells ließ sich nicht berechnen</translation>
    </message>
    <message>
        <source>: to explain it best, %1 would have to change</source>
        <translation>: Für die beste Erklärung müsste sich ändern: %1</translation>
    </message>
    <message>
        <source>the misfit is no larger than noise and the errors of m, b and k explain</source>
        <translation>der Modellfehler ist nicht größer, als Rauschen und die Fehler von m, b und k erklären</translation>
    </message>
    <message>
        <source>, though it is not white: slow noise, or a term that is missing here and there alike</source>
        <translation>, er ist allerdings nicht weiß: langsames Rauschen oder ein Anteil, der hier wie dort fehlt</translation>
    </message>
    <message>
        <source>the model misses by more than noise and the errors of m, b and k explain</source>
        <translation>das Modell liegt weiter daneben, als Rauschen und die Fehler von m, b und k erklären</translation>
    </message>
    <message>
        <source>m, b and k hold here too, but the residuals still follow the force: the object does something that the model does not</source>
        <translation>m, b und k gelten auch hier, aber die Residuen folgen noch der Kraft: Das Objekt zeigt etwas, was das Modell nicht enthält</translation>
    </message>
    <message>
        <source>this record does not tell m, b and k, so that the misfit could not be judged</source>
        <translation>aus dieser Aufnahme sind m, b und k nicht zu bestimmen, sodass der Modellfehler nicht zu beurteilen war</translation>
    </message>
    <message>
        <source>the noise of this record could not be told from the misfit</source>
        <translation>das Rauschen dieser Aufnahme war nicht vom Modellfehler zu trennen</translation>
    </message>
    <message>
        <source>there is no estimate to hold against this record</source>
        <translation>keine Schätzung, die an dieser Aufnahme zu prüfen wäre</translation>
    </message>
    <message>
        <source>too few samples without a loss to hold a model against</source>
        <translation>zu wenige Abtastwerte ohne Verlust, um ein Modell daran zu prüfen</translation>
    </message>
    <message>
        <source>with these parameters the motion leaves all bounds here</source>
        <translation>mit diesen Parametern verlässt die Bewegung hier alle Grenzen</translation>
    </message>
    <message>
        <source>the model explains this record to the last digit</source>
        <translation>das Modell erklärt diese Aufnahme bis zur letzten Stelle</translation>
    </message>
    <message>
        <source>not judged: the estimate is for a force that answers to the position, which a simulation from the measured force cannot judge</source>
        <translation>nicht beurteilt: Die Schätzung gilt für eine Kraft, die auf den Weg reagiert; eine Simulation aus der gemessenen Kraft kann das nicht beurteilen</translation>
    </message>
    <message>
        <source>not judged: the estimate has no errors to compare the misfit with</source>
        <translation>nicht beurteilt: Die Schätzung hat keine Fehler, mit denen der Modellfehler zu vergleichen wäre</translation>
    </message>
    <message>
        <source>fewer than %1 samples are too few to estimate on one part and check on the other; validate with another squeeze</source>
        <translation>weniger als %1 Abtastwerte sind zu wenige, um an einem Teil zu schätzen und am anderen zu prüfen; mit einem anderen Druckversuch validieren</translation>
    </message>
    <message>
        <source>the first 60 % of the record alone do not give m, b and k; validate with another squeeze</source>
        <translation>die ersten 60 % der Aufnahme allein ergeben m, b und k nicht; mit einem anderen Druckversuch validieren</translation>
    </message>
    <message>
        <source>the other recording is in %1 and %2, which cannot be compared with %3 and %4</source>
        <translation>die andere Aufnahme hat die Einheiten %1 und %2, die mit %3 und %4 nicht zu vergleichen sind</translation>
    </message>
    <message>
        <source>the other recording cannot be used: its channels differ in length or hold values that are no numbers</source>
        <translation>die andere Aufnahme ist nicht brauchbar: Ihre Kanäle sind verschieden lang oder enthalten Werte, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>%1 samples are missing in %2 places</source>
        <translation>%1 Abtastwerte fehlen an %2 Stellen</translation>
    </message>
    <message>
        <source>, too much of the squeeze. Check the cable and the load of the computer, then squeeze again.</source>
        <translation>, zu viel vom Druckversuch. Kabel und Auslastung des Rechners prüfen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>. The estimate (%1) is of the longest stretch without any, %2 of %3 samples; oe uses all. Check the cable and the load of the computer.</source>
        <translation>. Die Schätzung (%1) stammt vom längsten Stück ohne Lücke, %2 von %3 Abtastwerten; oe nutzt alle. Kabel und Auslastung des Rechners prüfen.</translation>
    </message>
    <message>
        <source>. Their forces count as unknown, which the errors include. Check the cable and the load of the computer.</source>
        <translation>. Ihre Kräfte gelten als unbekannt, was die Fehler berücksichtigen. Kabel und Auslastung des Rechners prüfen.</translation>
    </message>
    <message>
        <source>the gripper&apos;s clock jumped %1 times during the squeeze, so how long things took is in doubt. Squeeze again; where it happens again, check the gripper&apos;s power supply and firmware.</source>
        <translation>die Uhr des Greifers sprang während des Druckversuchs %1-mal, sodass Zeiten zweifelhaft sind. Erneut drücken; bei Wiederholung Stromversorgung und Firmware des Greifers prüfen.</translation>
    </message>
    <message>
        <source>the gripper fell silent %1 times during the squeeze, for up to %2 s. Check its cable and hub, then squeeze again.</source>
        <translation>der Greifer verstummte während des Druckversuchs %1-mal, bis zu %L2 s lang. Kabel und Hub prüfen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>no sample is missing, though</source>
        <translation>kein Abtastwert fehlt, aber</translation>
    </message>
    <message>
        <source>no sample is missing</source>
        <translation>kein Abtastwert fehlt</translation>
    </message>
    <message>
        <source>nothing in the recording was beyond mending</source>
        <translation>in der Aufnahme war nichts, was sich nicht beheben ließ</translation>
    </message>
    <message>
        <source>not judged without an estimate</source>
        <translation>ohne Schätzung nicht beurteilt</translation>
    </message>
    <message>
        <source>the force moves the object enough to tell m and k</source>
        <translation>die Kraft bewegt das Objekt genug, um m und k zu bestimmen</translation>
    </message>
    <message>
        <source>the %1 is known to %2 % only. Squeeze longer or with a force that varies %3.</source>
        <translation>die %1 ist nur auf %L2 % bekannt. Länger drücken oder mit einer Kraft, die sich %3 ändert.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>schneller</translation>
    </message>
    <message>
        <source>more slowly</source>
        <translation>langsamer</translation>
    </message>
    <message>
        <source>not judged: there is nothing to test</source>
        <translation>nicht beurteilt: Es gibt nichts zu prüfen</translation>
    </message>
    <message>
        <source>; too little to matter</source>
        <translation>; zu wenig, um ins Gewicht zu fallen</translation>
    </message>
    <message>
        <source>; counted in the errors, which are up to %1 times as large</source>
        <translation>; in den Fehlern berücksichtigt, die bis zu %L1-mal so groß sind</translation>
    </message>
    <message>
        <source>the force is measured with noise of %1 (standard deviation)</source>
        <translation>die Kraft wird mit einem Rauschen von %L1 gemessen (Standardabweichung)</translation>
    </message>
    <message>
        <source>the residuals are not white: a noise model of order %1 describes them</source>
        <translation>die Residuen sind nicht weiß: Ein Rauschmodell der Ordnung %1 beschreibt sie</translation>
    </message>
    <message>
        <source>the residuals look like white noise</source>
        <translation>die Residuen sehen aus wie weißes Rauschen</translation>
    </message>
    <message>
        <source>the residuals are not white%1: something besides sensor noise is in the position, and the errors shown are too small. Check for a loose grip, vibration and drift</source>
        <translation>die Residuen sind nicht weiß%1: Im Weg steckt mehr als Sensorrauschen, und die gezeigten Fehler sind zu klein. Auf lockeren Griff, Erschütterungen und Drift prüfen</translation>
    </message>
    <message>
        <source>, and no noise model describes them</source>
        <translation>, und kein Rauschmodell beschreibt sie</translation>
    </message>
    <message>
        <source>the residuals do not depend on the force</source>
        <translation>die Residuen hängen nicht von der Kraft ab</translation>
    </message>
    <message>
        <source>the residuals depend on the force: the object is not just a mass, a spring and a damper at this force, or the hold or the lag is wrong. Check these, and compare with duffing</source>
        <translation>die Residuen hängen von der Kraft ab: Das Objekt ist bei dieser Kraft nicht nur Masse, Feder und Dämpfer, oder Kraftverlauf oder Zeitversatz ist falsch. Diese prüfen und mit duffing vergleichen</translation>
    </message>
    <message>
        <source>the spring is straight at this force</source>
        <translation>die Feder ist bei dieser Kraft gerade</translation>
    </message>
    <message>
        <source>the spring is not straight: with a curved one m, b or k moves by up to %1 %, %2 standard errors. Use duffing, or squeeze with a smaller peak</source>
        <translation>die Feder ist nicht gerade: Mit einer gekrümmten verschiebt sich m, b oder k um bis zu %L1 %, %L2 Standardfehler. Duffing verwenden oder mit kleinerer Spitze drücken</translation>
    </message>
    <message>
        <source>the force does not answer to the position</source>
        <translation>die Kraft hängt nicht vom Weg ab</translation>
    </message>
    <message>
        <source>the force answers to disturbances of the position, as under feedback: m, b and k are biased. Squeeze with a repeated excitation and use periodic, or control the force less stiffly</source>
        <translation>die Kraft reagiert auf Störungen des Wegs, wie bei einer Rückkopplung: m, b und k sind verfälscht. Mit wiederholter Anregung drücken und periodic verwenden oder die Kraft weniger steif regeln</translation>
    </message>
    <message>
        <source> with gripper %1</source>
        <translation> mit Greifer %1</translation>
    </message>
    <message>
        <source>the position fits the force hold %1 clearly better than %2, which was used: m and b are off. Name the right hold, or check the lag between the channels.</source>
        <translation>der Weg passt deutlich besser zum Kraftverlauf %1 als zu %2, der verwendet wurde: m und b liegen daneben. Den richtigen Kraftverlauf angeben oder den Zeitversatz der Kanäle prüfen.</translation>
    </message>
    <message>
        <source>over %1 squeezes%2 the position fits the force hold %3 clearly better than %4, which was used: m and b of this squeeze are off, and those of the earlier ones too. Name the right hold, or measure the lag between the channels, and identify them again.</source>
        <translation>über %1 Druckversuche%2 passt der Weg deutlich besser zum Kraftverlauf %3 als zu %4, der verwendet wurde: m und b dieses Druckversuchs liegen daneben, die der früheren auch. Den richtigen Kraftverlauf angeben oder den Zeitversatz der Kanäle messen und neu identifizieren.</translation>
    </message>
    <message>
        <source> This squeeze alone agrees with %1: see whether the gripper was changed in between.</source>
        <translation> Dieser Druckversuch allein passt zu %1: nachsehen, ob der Greifer zwischendurch verändert wurde.</translation>
    </message>
    <message>
        <source>over %1 squeezes%2 the position agrees with the force hold %3 and not with %4</source>
        <translation>über %1 Druckversuche%2 passt der Weg zum Kraftverlauf %3 und nicht zu %4</translation>
    </message>
    <message>
        <source>the position agrees with the force hold %1 and not with %2</source>
        <translation>der Weg passt zum Kraftverlauf %1 und nicht zu %2</translation>
    </message>
    <message>
        <source>the force hold %1 was asked for</source>
        <translation>der Kraftverlauf %1 war verlangt</translation>
    </message>
    <message>
        <source>the force hold %1 is the recording&apos;s own</source>
        <translation>der Kraftverlauf %1 ist der der Aufnahme</translation>
    </message>
    <message>
        <source>the recording names no force hold; %1 was assumed</source>
        <translation>die Aufnahme nennt keinen Kraftverlauf; %1 wurde angenommen</translation>
    </message>
    <message>
        <source>; %1 squeezes together cannot tell it from %2</source>
        <translation>; %1 Druckversuche zusammen unterscheiden ihn nicht von %2</translation>
    </message>
    <message>
        <source>; this record cannot tell it from %1</source>
        <translation>; diese Aufnahme unterscheidet ihn nicht von %1</translation>
    </message>
    <message>
        <source>the estimator reached its answer</source>
        <translation>der Schätzer fand sein Ergebnis</translation>
    </message>
    <message>
        <source>no m, b and k above zero were found. Squeeze again.</source>
        <translation>m, b und k größer als null waren nicht zu finden. Erneut drücken.</translation>
    </message>
    <message>
        <source>the model follows the position</source>
        <translation>das Modell folgt dem Weg</translation>
    </message>
    <message>
        <source>the model does not follow the position. Look at the residuals: noise, a loose grip and an object that is no mass, spring and damper all do this.</source>
        <translation>das Modell folgt dem Weg nicht. Die Residuen ansehen: Rauschen, ein lockerer Griff oder ein Objekt, das nicht Masse, Feder und Dämpfer ist, bewirken das.</translation>
    </message>
    <message>
        <source>not judged: the channels carry the device&apos;s own calibration</source>
        <translation>nicht beurteilt: Die Kanäle tragen die eigene Kalibrierung des Geräts</translation>
    </message>
    <message>
        <source>the calibrations held on that day</source>
        <translation>die Kalibrierungen galten an diesem Tag</translation>
    </message>
    <message>
        <source>the calibration of the %1 was overdue by %2 days. Calibrate it, then squeeze again.</source>
        <translation>die Kalibrierung war %2 Tage überfällig (%1). Kalibrieren, dann erneut drücken.</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>%1 wrong of %2: at most %3 with %4 confidence</source>
        <translation>%1 von %2 falsch: höchstens %3 bei einem Vertrauensniveau von %4</translation>
    </message>
    <message>
        <source>; %1 without one are needed to show %2</source>
        <translation>; %1 ohne Fehler sind nötig, um %2 zu zeigen</translation>
    </message>
    <message>
        <source>silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>Calinski-Harabasz</source>
        <translation>Calinski-Harabasz</translation>
    </message>
    <message>
        <source>Davies-Bouldin</source>
        <translation>Davies-Bouldin</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Gap</translation>
    </message>
    <message>
        <source>BIC</source>
        <translation>BIC</translation>
    </message>
    <message>
        <source>One group: nothing speaks for more.</source>
        <translation>Eine Gruppe: Nichts spricht für mehr.</translation>
    </message>
    <message>
        <source>One group: %1 can say so and do; the other criteria compare two groups and more only.</source>
        <translation>Eine Gruppe: %1 kann das sagen und tut es; die anderen Kriterien vergleichen erst ab zwei Gruppen.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <translation>%1 für %2</translation>
    </message>
    <message>
        <source>%1 groups: %2 for it</source>
        <translation>%1 Gruppen: %2 dafür</translation>
    </message>
    <message>
        <source>; %1</source>
        <translation>; %1</translation>
    </message>
    <message>
        <source>; of equals the silhouette&apos;s</source>
        <translation>; bei Gleichstand nach der Silhouette</translation>
    </message>
    <message>
        <source>; of equals the fewest groups</source>
        <translation>; bei Gleichstand die wenigsten Gruppen</translation>
    </message>
    <message>
        <source>The table to be clustered</source>
        <translation>Die zu gruppierende Tabelle</translation>
    </message>
    <message>
        <source>found no rows</source>
        <translation>gefunden: keine Zeilen</translation>
    </message>
    <message>
        <source>expected at least one</source>
        <translation>erwartet: mindestens eine</translation>
    </message>
    <message>
        <source>found numbers that are not finite or too large</source>
        <translation>gefunden: Zahlen, die nicht endlich oder zu groß sind</translation>
    </message>
    <message>
        <source>expected finite ones whose squares can be added</source>
        <translation>erwartet: endliche, deren Quadrate sich addieren lassen</translation>
    </message>
    <message>
        <source>The grouping</source>
        <translation>Das Gruppieren</translation>
    </message>
    <message>
        <source>%1 must be at least 1, not %2.</source>
        <translation>%1 muss mindestens 1 sein, nicht %2.</translation>
    </message>
    <message>
        <source>The table</source>
        <translation>Die Tabelle</translation>
    </message>
    <message>
        <source>it has %1 rows</source>
        <translation>sie hat %1 Zeilen</translation>
    </message>
    <message>
        <source>at least %1 rows, one a cluster, were expected</source>
        <translation>erwartet: mindestens %1 Zeilen, eine je Cluster</translation>
    </message>
    <message>
        <source>Too few squeezes since the enrolment to say whether anything has moved.</source>
        <translation>Zu wenige Druckversuche seit dem Einlernen, um zu sagen, ob sich etwas verschoben hat.</translation>
    </message>
    <message>
        <source>No type has moved since its enrolment.</source>
        <translation>Kein Typ hat sich seit dem Einlernen verschoben.</translation>
    </message>
    <message>
        <source>All types have moved by the same factors: the force or the position channel, not the products. Check the sensors&apos; calibration.</source>
        <translation>Alle Typen haben sich um dieselben Faktoren verschoben: der Kraft- oder Wegkanal, nicht die Produkte. Die Kalibrierung der Sensoren prüfen.</translation>
    </message>
    <message>
        <source>The same mass, damping and stiffness has come on top of all types: the fingers or their baseline. Measure the empty gripper again.</source>
        <translation>Bei allen Typen ist die gleiche Masse, Dämpfung und Steifigkeit hinzugekommen: die Finger oder ihr Leerwert. Den leeren Greifer neu messen.</translation>
    </message>
    <message>
        <source>All types have moved together: the gripper, its sensors or its fingers, not the products.</source>
        <translation>Alle Typen haben sich gemeinsam verschoben: der Greifer, seine Sensoren oder Finger, nicht die Produkte.</translation>
    </message>
    <message>
        <source>Of all types only %1 moved: the product itself, not the gripper.</source>
        <translation>Von allen Typen hat sich nur %1 verschoben: das Produkt selbst, nicht der Greifer.</translation>
    </message>
    <message>
        <source>%1 moved, but the squeezes are too few to tell the product from the gripper. Squeeze parts of other types too.</source>
        <translation>%1 hat sich verschoben, aber die Druckversuche sind zu wenige, um Produkt und Greifer zu trennen. Auch Teile anderer Typen drücken.</translation>
    </message>
    <message>
        <source>%1 has moved. Squeeze parts of another type too: only that tells the product from the gripper.</source>
        <translation>%1 hat sich verschoben. Auch Teile eines anderen Typs drücken: Nur das trennt Produkt und Greifer.</translation>
    </message>
    <message>
        <source>%1 have moved, each in its own way: no single cause in the gripper explains it.</source>
        <translation>%1 haben sich verschoben, jeder auf seine Weise: Keine einzelne Ursache im Greifer erklärt das.</translation>
    </message>
    <message>
        <source>All types: %1.</source>
        <translation>Alle Typen: %1.</translation>
    </message>
    <message>
        <source>%1, last %2 squeezes: %3.</source>
        <translation>%1, letzte %2 Druckversuche: %3.</translation>
    </message>
    <message>
        <source>%1: its charts gave the alarm at squeeze %2 of %3.</source>
        <translation>%1: Die Regelkarten gaben bei Druckversuch %2 von %3 Alarm.</translation>
    </message>
    <message>
        <source>The weight of the newest squeeze must be between 0.05 and 1.</source>
        <translation>Das Gewicht des neuesten Druckversuchs muss zwischen 0,05 und 1 liegen.</translation>
    </message>
    <message>
        <source>The run length must be between 20 and 100,000 squeezes.</source>
        <translation>Die Lauflänge muss zwischen 20 und 100 000 Druckversuchen liegen.</translation>
    </message>
    <message>
        <source>At least %1 recent squeezes.</source>
        <translation>Mindestens %1 neuere Druckversuche.</translation>
    </message>
    <message>
        <source>The share of false alarms must be between 1e-6 and 0.5.</source>
        <translation>Der Anteil der Fehlalarme muss zwischen 1e-6 und 0,5 liegen.</translation>
    </message>
    <message>
        <source>There are no limits for this weight and run length.</source>
        <translation>Für dieses Gewicht und diese Lauflänge gibt es keine Grenzen.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>The squeeze had ended early, after %1 s.</source>
        <translation>Der Druckversuch war früh zu Ende, nach %1 s.</translation>
    </message>
    <message>
        <source>Decided after %1 s.</source>
        <translation>Entschieden nach %1 s.</translation>
    </message>
    <message>
        <source>The squeeze ended after %1 s as %2, but all that was recorded by then does not show it.</source>
        <translation>Der Druckversuch endete nach %1 s als %2, aber alles bis dahin Aufgenommene zeigt das nicht.</translation>
    </message>
    <message>
        <source>The squeeze ended after %1 s as %2, but all that was recorded by then says %3.</source>
        <translation>Der Druckversuch endete nach %1 s als %2, aber alles bis dahin Aufgenommene sagt %3.</translation>
    </message>
    <message>
        <source>Squeeze it again.</source>
        <translation>Erneut drücken.</translation>
    </message>
    <message>
        <source>%1 after %2 s, posterior %3</source>
        <translation>%1 nach %2 s, A-posteriori-Wahrscheinlichkeit %3</translation>
    </message>
    <message>
        <source>fewer than 1 in 100</source>
        <translation>weniger als 1 von 100</translation>
    </message>
    <message>
        <source>%1 in 100</source>
        <translation>%1 von 100</translation>
    </message>
    <message>
        <source>1 more squeeze</source>
        <translation>1 weiterer Druckversuch</translation>
    </message>
    <message>
        <source>%1 more squeezes</source>
        <translation>%1 weitere Druckversuche</translation>
    </message>
    <message>
        <source>One squeeze says where %1 is, but nothing of how squeezes of it differ.</source>
        <translation>Ein Druckversuch sagt, wo %1 liegt, aber nichts darüber, wie sich seine Druckversuche unterscheiden.</translation>
    </message>
    <message>
        <source>One squeeze tells the stiffness of %1 only to %2 % (95 %), if its squeezes differ as those of the other types do.</source>
        <translation>Ein Druckversuch verrät die Steifigkeit von %1 nur auf %2 % (95 %), wenn sich seine Druckversuche wie die der anderen Typen unterscheiden.</translation>
    </message>
    <message>
        <source>No verdict can be given yet: %1 and there is a gate.</source>
        <translation>Noch ist kein Urteil möglich: %1, dann gibt es eine Grenze.</translation>
    </message>
    <message>
        <source>Row %1, feature %2</source>
        <translation>Zeile %1, Merkmal %2</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a number above 0, since its logarithm is asked for</source>
        <translation>eine Zahl über 0, da ihr Logarithmus verlangt ist</translation>
    </message>
    <message>
        <source>Feature %1</source>
        <translation>Merkmal %1</translation>
    </message>
    <message>
        <source>found numbers too large or too small</source>
        <translation>gefunden: zu große oder zu kleine Zahlen</translation>
    </message>
    <message>
        <source>expected numbers whose squares can be computed</source>
        <translation>erwartet: Zahlen, deren Quadrate sich berechnen lassen</translation>
    </message>
    <message>
        <source>No feature is named.</source>
        <translation>Kein Merkmal ist genannt.</translation>
    </message>
    <message>
        <source>%1, as in the header</source>
        <translation>%1, wie in der Kopfzeile</translation>
    </message>
    <message>
        <source>The centres to start from do not fit the table.</source>
        <translation>Die Startzentren passen nicht zur Tabelle.</translation>
    </message>
    <message>
        <source>The centres to start from</source>
        <translation>Die Startzentren</translation>
    </message>
    <message>
        <source>found one too far away</source>
        <translation>gefunden: eines zu weit weg</translation>
    </message>
    <message>
        <source>expected centres near the items</source>
        <translation>erwartet: Zentren nahe den Einträgen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>A map of %1 x %2 units is not between 1 and %3 units.</source>
        <translation>Eine Karte mit %1 x %2 Einheiten liegt nicht zwischen 1 und %3 Einheiten.</translation>
    </message>
    <message>
        <source>A map has too few units for %1 groups.</source>
        <translation>Eine Karte hat zu wenige Einheiten für %1 Gruppen.</translation>
    </message>
    <message>
        <source>%1 times that of the others</source>
        <translation>das %1-Fache der anderen</translation>
    </message>
    <message>
        <source>%1 % above the others</source>
        <translation>%1 % über den anderen</translation>
    </message>
    <message>
        <source>%1 % below the others</source>
        <translation>%1 % unter den anderen</translation>
    </message>
    <message>
        <source>%1 is %2, %3 of their standard deviations.</source>
        <translation>%1 ist %2, %3 ihrer Standardabweichungen.</translation>
    </message>
    <message>
        <source>Mass, damping and stiffness are each near those of the others, but do not go together as theirs do: %1 standard deviations away.</source>
        <translation>Masse, Dämpfung und Steifigkeit liegen einzeln nahe denen der anderen, passen aber nicht so zusammen wie bei diesen: %1 Standardabweichungen entfernt.</translation>
    </message>
    <message>
        <source>Mass, damping and stiffness need a column each: three names.</source>
        <translation>Masse, Dämpfung und Steifigkeit brauchen je eine Spalte: drei Namen.</translation>
    </message>
    <message>
        <source>The errors of m, b and k need a column each: three names.</source>
        <translation>Die Fehler von m, b und k brauchen je eine Spalte: drei Namen.</translation>
    </message>
    <message>
        <source>Neither a type nor a column with types is named.</source>
        <translation>Weder ein Typ noch eine Spalte mit Typen ist genannt.</translation>
    </message>
    <message>
        <source>the name of a type</source>
        <translation>der Name eines Typs</translation>
    </message>
    <message>
        <source>a standard error, zero or above</source>
        <translation>ein Standardfehler, null oder größer</translation>
    </message>
    <message>
        <source>a number above zero</source>
        <translation>eine Zahl größer als null</translation>
    </message>
    <message>
        <source>a quote that is not closed</source>
        <translation>ein nicht geschlossenes Anführungszeichen</translation>
    </message>
    <message>
        <source>a closing quote on the same line</source>
        <translation>ein schließendes Anführungszeichen in derselben Zeile</translation>
    </message>
    <message>
        <source>an empty file</source>
        <translation>eine leere Datei</translation>
    </message>
    <message>
        <source>a header and rows</source>
        <translation>eine Kopfzeile und Zeilen</translation>
    </message>
    <message>
        <source>the columns %1</source>
        <translation>die Spalten %1</translation>
    </message>
    <message>
        <source>a column called %1</source>
        <translation>eine Spalte namens %1</translation>
    </message>
    <message>
        <source>a second column called %1</source>
        <translation>eine zweite Spalte namens %1</translation>
    </message>
    <message>
        <source>each name once</source>
        <translation>jeder Name einmal</translation>
    </message>
    <message>
        <source>no rows</source>
        <translation>keine Zeilen</translation>
    </message>
    <message>
        <source>at least one row below the header</source>
        <translation>mindestens eine Zeile unter der Kopfzeile</translation>
    </message>
    <message>
        <source>No squeeze of an enrolled type: nothing can be said of the transfer. Squeeze parts of two or more enrolled types on this gripper.</source>
        <translation>Kein Druckversuch eines eingelernten Typs: Über die Übertragung lässt sich nichts sagen. Teile von zwei oder mehr eingelernten Typen mit diesem Greifer drücken.</translation>
    </message>
    <message>
        <source>What this gripper finds differs from that of the enrolment: %1.</source>
        <translation>Was dieser Greifer findet, weicht von dem des Einlernens ab: %1.</translation>
    </message>
    <message>
        <source>The types differ in it by more than chance: one adjustment does not serve them all.</source>
        <translation>Die Typen unterscheiden sich darin mehr als zufällig: Eine Anpassung taugt nicht für alle.</translation>
    </message>
    <message>
        <source>Of %1 squeezes left out, %2 are named right as measured and %3 adjusted.</source>
        <translation>Von %1 ausgelassenen Druckversuchen werden %2 wie gemessen richtig benannt und %3 nach Anpassung.</translation>
    </message>
    <message>
        <source>The adjustment helps: use it.</source>
        <translation>Die Anpassung hilft: verwenden.</translation>
    </message>
    <message>
        <source>The adjustment does not help: the types serve as they are, or must be enrolled here.</source>
        <translation>Die Anpassung hilft nicht: Die Typen taugen, wie sie sind, oder müssen hier eingelernt werden.</translation>
    </message>
    <message>
        <source>Only one type was squeezed here; how others fare is not known.</source>
        <translation>Nur ein Typ wurde hier gedrückt; wie es anderen ergeht, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 in 1,000</source>
        <translation>%1 von 1000</translation>
    </message>
    <message>
        <source>%1 and %2 overlap: of the squeezes of %1, about %3 cannot be told from %2</source>
        <translation>%1 und %2 überlappen: Von den Druckversuchen von %1 sind etwa %3 nicht von %2 zu unterscheiden</translation>
    </message>
    <message>
        <source>, and %1 are called %2</source>
        <translation>, und %1 heißen %2</translation>
    </message>
    <message>
        <source>; of those of %2, about %3 cannot be told from %1</source>
        <translation>; von denen von %2 sind etwa %3 nicht von %1 zu unterscheiden</translation>
    </message>
    <message>
        <source>mass %1, damping %2, stiffness %3</source>
        <translation>Masse %1, Dämpfung %2, Steifigkeit %3</translation>
    </message>
    <message>
        <source>The rate %1 must be between %2 and %3, not %4.</source>
        <translation>Die Fehlerrate %1 muss zwischen %L2 und %L3 liegen, nicht bei %L4.</translation>
    </message>
    <message>
        <source>The confidence must be between %1 and %2, not %3.</source>
        <translation>Das Vertrauensniveau muss zwischen %L1 und %L2 liegen, nicht bei %L3.</translation>
    </message>
    <message>
        <source>The instrument&apos;s range must have lowest values above zero and below the highest.</source>
        <translation>Der Messbereich muss kleinste Werte über null haben, die unter den größten liegen.</translation>
    </message>
    <message>
        <source>Mass, damping and stiffness are not all above zero.</source>
        <translation>Masse, Dämpfung und Steifigkeit sind nicht alle größer als null.</translation>
    </message>
    <message>
        <source>%1 times that of %2</source>
        <translation>das %1-Fache von %2</translation>
    </message>
    <message>
        <source>%1 above that of %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>%1 below that of %2</source>
        <translation>%1 unter %2</translation>
    </message>
    <message>
        <source>Mass, damping and stiffness are where %1 sits; it is the only type enrolled.</source>
        <translation>Masse, Dämpfung und Steifigkeit liegen, wo %1 liegt; es ist der einzige eingelernte Typ.</translation>
    </message>
    <message>
        <source>%1 is where %2 sits; the next type, %3, is %4 sd away.</source>
        <translation>%1 liegt, wo %2 liegt; der nächste Typ, %3, ist %4 σ entfernt.</translation>
    </message>
    <message>
        <source>%1 is %2, the nearest type.</source>
        <translation>%1 liegt %2, dem nächsten Typ.</translation>
    </message>
    <message>
        <source>That is %1 sd away; squeezes of %2 stay within %3 sd.</source>
        <translation>Das sind %1 σ Abstand; Druckversuche von %2 bleiben innerhalb von %3 σ.</translation>
    </message>
    <message>
        <source>Each of mass, damping and stiffness alone could be %1, but not the three together.</source>
        <translation>Masse, Dämpfung und Steifigkeit könnten einzeln %1 sein, aber nicht alle drei zusammen.</translation>
    </message>
    <message>
        <source>The squeeze could be %1 (%2) or %3 (%4).</source>
        <translation>Der Druckversuch könnte %1 (%2) oder %3 (%4) sein.</translation>
    </message>
    <message>
        <source>Squeezed %1 times as long, nine of ten would tell them apart.</source>
        <translation>Bei %1-mal so langem Drücken wären neun von zehn zu unterscheiden.</translation>
    </message>
    <message>
        <source>The two types lie so close that a longer squeeze would not tell them apart.</source>
        <translation>Die beiden Typen liegen so nahe beieinander, dass auch längeres Drücken sie nicht unterscheidet.</translation>
    </message>
    <message>
        <source>Squeeze it again; if this happens often, enrol more squeezes of both types.</source>
        <translation>Erneut drücken; kommt das oft vor, von beiden Typen weitere Druckversuche einlernen.</translation>
    </message>
    <message>
        <source>The squeeze could be %1, but lies so far out that a part of no enrolled type is as likely.</source>
        <translation>Der Druckversuch könnte %1 sein, liegt aber so weit außen, dass ein Teil keines eingelernten Typs ebenso wahrscheinlich ist.</translation>
    </message>
    <message>
        <source>Squeeze it again; enrolling more squeezes narrows what %1 is.</source>
        <translation>Erneut drücken; weitere eingelernte Druckversuche grenzen %1 enger ein.</translation>
    </message>
    <message>
        <source>The rate of false alarms asked for is too small for so few squeezes; enrol more.</source>
        <translation>Die verlangte Fehlalarmrate ist zu klein für so wenige Druckversuche; weitere einlernen.</translation>
    </message>
    <message>
        <source>Too few squeezes are enrolled to say what is usual: 1 more is needed.</source>
        <translation>Zu wenige Druckversuche sind eingelernt, um zu sagen, was üblich ist: 1 weiterer ist nötig.</translation>
    </message>
    <message>
        <source>Too few squeezes are enrolled to say what is usual: %1 more are needed.</source>
        <translation>Zu wenige Druckversuche sind eingelernt, um zu sagen, was üblich ist: %1 weitere sind nötig.</translation>
    </message>
    <message>
        <source>No mass, damping and stiffness could be found from this squeeze.</source>
        <translation>Aus diesem Druckversuch waren Masse, Dämpfung und Steifigkeit nicht zu bestimmen.</translation>
    </message>
    <message>
        <source>no gripper is connected</source>
        <translation>kein Greifer ist verbunden</translation>
    </message>
    <message>
        <source>it is armed, and hands are near: disarm it first</source>
        <translation>er ist scharf, und am Greifer wird gearbeitet: erst entschärfen</translation>
    </message>
    <message>
        <source>The reading hardly changed. Was the load put on?</source>
        <translation>Die Anzeige hat sich kaum geändert. Wurde die Last aufgelegt?</translation>
    </message>
    <message>
        <source>The reading went the other way than before. Is it the right load?</source>
        <translation>Die Anzeige ging in die andere Richtung als zuvor. Ist es die richtige Last?</translation>
    </message>
    <message>
        <source>take this point</source>
        <translation>diesen Punkt aufnehmen</translation>
    </message>
    <message>
        <source>the channel is at its end, so the load cannot be told</source>
        <translation>der Kanal ist am Ende, sodass die Last nicht zu bestimmen ist</translation>
    </message>
    <message>
        <source>the reading still moves (by %1 %2 within %3 s). Wait until it rests</source>
        <translation>die Anzeige bewegt sich noch (um %L1 %2 in %3 s). Warten, bis sie ruht</translation>
    </message>
    <message>
        <source>only %1 samples came</source>
        <translation>nur %1 Abtastwerte kamen an</translation>
    </message>
    <message>
        <source>A calibration is being stored. Wait for its end.</source>
        <translation>Eine Kalibrierung wird gespeichert. Das Ende abwarten.</translation>
    </message>
    <message>
        <source>There is no point to be taken now.</source>
        <translation>Jetzt ist kein Punkt aufzunehmen.</translation>
    </message>
    <message>
        <source>it is another gripper than the one that was begun with (%1)</source>
        <translation>es ist ein anderer Greifer als der, mit dem begonnen wurde (%1)</translation>
    </message>
    <message>
        <source>The calibration is not complete: %1 of %2 points are taken.</source>
        <translation>Die Kalibrierung ist nicht vollständig: %1 von %2 Punkten sind aufgenommen.</translation>
    </message>
    <message>
        <source>These points make no calibration: %1</source>
        <translation>Diese Punkte ergeben keine Kalibrierung: %1</translation>
    </message>
    <message>
        <source>The %1 was calibrated in %2, but the gripper now measures in %3: calibrate it again.</source>
        <translation>Kalibriert wurde in %2 (%1), der Greifer misst jetzt aber in %3: neu kalibrieren.</translation>
    </message>
    <message>
        <source>the link closed</source>
        <translation>die Verbindung wurde geschlossen</translation>
    </message>
    <message>
        <source>Gripper %1 came in its place: choose it to work with it, or plug gripper %2 in.</source>
        <translation>An seiner Stelle kam Greifer %1: diesen wählen, um mit ihm zu arbeiten, oder Greifer %2 anstecken.</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>scharf schalten</translation>
    </message>
    <message>
        <source>This is not the step for it.</source>
        <translation>Das gehört nicht zu diesem Schritt.</translation>
    </message>
    <message>
        <source>Accept or reject the last squeeze first.</source>
        <translation>Erst den letzten Druckversuch annehmen oder verwerfen.</translation>
    </message>
    <message>
        <source>The last squeeze is still being worked on.</source>
        <translation>Der letzte Druckversuch wird noch ausgewertet.</translation>
    </message>
    <message>
        <source>The type needs a name.</source>
        <translation>Der Typ braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is no squeeze to decide on.</source>
        <translation>Über keinen Druckversuch ist zu entscheiden.</translation>
    </message>
    <message>
        <source>This measurement is not valid and cannot be enrolled: %1</source>
        <translation>Diese Messung ist ungültig und kann nicht eingelernt werden: %1</translation>
    </message>
    <message>
        <source>Only an accepted squeeze can be dropped.</source>
        <translation>Nur ein angenommener Druckversuch kann verworfen werden.</translation>
    </message>
    <message>
        <source>A type needs at least %1 accepted squeezes; there are %2.</source>
        <translation>Ein Typ braucht mindestens %1 angenommene Druckversuche; es sind %2.</translation>
    </message>
    <message>
        <source>%1 is retired. Put it back into use first, or choose another name.</source>
        <translation>%1 ist außer Gebrauch. Erst wieder in Gebrauch nehmen oder einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Peak force, bit, length and limits of a recipe must be above zero.</source>
        <translation>Spitzenkraft, Bit, Dauer und Grenzen eines Rezepts müssen größer als null sein.</translation>
    </message>
    <message>
        <source>The preload of a recipe must be zero or above.</source>
        <translation>Die Vorlast eines Rezepts muss null oder größer sein.</translation>
    </message>
    <message>
        <source>Preload plus peak force</source>
        <translation>Vorlast plus Spitzenkraft</translation>
    </message>
    <message>
        <source>the recipe&apos;s</source>
        <translation>die des Rezepts</translation>
    </message>
    <message>
        <source>The library is still being read.</source>
        <translation>Die Bibliothek wird noch gelesen.</translation>
    </message>
    <message>
        <source>The inspection</source>
        <translation>Die Prüfung</translation>
    </message>
    <message>
        <source>There is no lag that was measured well enough to be used.</source>
        <translation>Kein Zeitversatz wurde gut genug gemessen, um ihn zu verwenden.</translation>
    </message>
    <message>
        <source>lag from %1 squeezes</source>
        <translation>Zeitversatz aus %1 Druckversuchen</translation>
    </message>
    <message>
        <source>a pull of %1</source>
        <translation>einen Zug von %1</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>The force signal has %1 at sample %2; a gripper can only push. Raise the bias or lower the peak.</source>
        <translation>Das Kraftsignal hat %1 bei Abtastwert %2; ein Greifer kann nur drücken. Die Grundkraft erhöhen oder die Spitze senken.</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>drücken</translation>
    </message>
    <message>
        <source>it only listens</source>
        <translation>er wird nur abgehört</translation>
    </message>
    <message>
        <source>The force signal is empty. Choose a longer squeeze.</source>
        <translation>Das Kraftsignal ist leer. Einen längeren Druckversuch wählen.</translation>
    </message>
    <message>
        <source>The force signal has %1 samples; the gripper holds at most %2. Choose a shorter squeeze.</source>
        <translation>Das Kraftsignal hat %1 Abtastwerte; der Greifer fasst höchstens %2. Einen kürzeren Druckversuch wählen.</translation>
    </message>
    <message>
        <source>The force</source>
        <translation>Die Kraft</translation>
    </message>
    <message>
        <source>the gripper&apos;s own</source>
        <translation>die eigene des Greifers</translation>
    </message>
    <message>
        <source>Only a person may arm the gripper, and no name was given.</source>
        <translation>Nur eine Person darf den Greifer scharf schalten, und kein Name ist genannt.</translation>
    </message>
    <message>
        <source>the link is %1</source>
        <translation>die Verbindung ist: %1</translation>
    </message>
    <message>
        <source>move</source>
        <translation>bewegen</translation>
    </message>
    <message>
        <source>it no longer heard from this program</source>
        <translation>er hörte nichts mehr von diesem Programm</translation>
    </message>
    <message>
        <source>the force limit was reached</source>
        <translation>die Kraftgrenze war erreicht</translation>
    </message>
    <message>
        <source>the travel limit was reached</source>
        <translation>die Weggrenze war erreicht</translation>
    </message>
    <message>
        <source>it reports a fault</source>
        <translation>er meldet einen Fehler</translation>
    </message>
    <message>
        <source>A squeeze is under way. Wait for its end or stop it.</source>
        <translation>Ein Druckversuch läuft. Das Ende abwarten oder anhalten.</translation>
    </message>
    <message>
        <source>What the library knows of this gripper could not be read, so nothing is squeezed; it is asked again every 2 seconds. %1</source>
        <translation>Was die Bibliothek von diesem Greifer weiß, konnte nicht gelesen werden; darum wird nicht gedrückt. Sie wird alle 2 Sekunden erneut gefragt. %1</translation>
    </message>
    <message>
        <source>The library is still being asked what is known of this gripper. Wait a moment, then squeeze again.</source>
        <translation>Die Bibliothek wird noch gefragt, was von diesem Greifer bekannt ist. Einen Moment warten, dann erneut drücken.</translation>
    </message>
    <message>
        <source>cannot be seen: the gripper sends neither a number nor a clock</source>
        <translation>nicht zu erkennen: Der Greifer sendet weder Nummer noch Uhrzeit</translation>
    </message>
    <message>
        <source>send anything</source>
        <translation>etwas senden</translation>
    </message>
    <message>
        <source>go on with the squeeze</source>
        <translation>den Druckversuch fortsetzen</translation>
    </message>
    <message>
        <source>The squeeze</source>
        <translation>Der Druckversuch</translation>
    </message>
    <message>
        <source>it ended early, without a reason</source>
        <translation>er endete früh, ohne Grund</translation>
    </message>
    <message>
        <source>it gave no reason</source>
        <translation>er nannte keinen Grund</translation>
    </message>
    <message>
        <source>finish the squeeze</source>
        <translation>den Druckversuch beenden</translation>
    </message>
    <message>
        <source>Listening needs a time above zero.</source>
        <translation>Abhören braucht eine Zeit über null.</translation>
    </message>
    <message>
        <source>it was disconnected</source>
        <translation>er wurde getrennt</translation>
    </message>
    <message>
        <source>it went away during the squeeze</source>
        <translation>er verschwand während des Druckversuchs</translation>
    </message>
    <message>
        <source>peak must be a number from 0 up</source>
        <translation>die Spitze muss eine Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>bias must be a number</source>
        <translation>die Grundkraft muss eine Zahl sein</translation>
    </message>
    <message>
        <source>samples must be from 1 to %1</source>
        <translation>die Zahl der Abtastwerte muss 1 bis %1 sein</translation>
    </message>
    <message>
        <source>the bit time must be above 0 s</source>
        <translation>die Bitdauer muss über 0 s liegen</translation>
    </message>
    <message>
        <source>bias plus peak must not be negative: a one-sided grip can only push</source>
        <translation>Grundkraft plus Spitze darf nicht negativ sein: Ein einseitiger Griff kann nur drücken</translation>
    </message>
    <message>
        <source>%1 periods of the shortest inverse-repeat sequence, of 14 bits, do not fit: take more samples, shorter bits or fewer periods</source>
        <translation>%1 Perioden der kürzesten inverse-repeat-Folge mit 14 Bit passen nicht hinein: mehr Abtastwerte, kürzere Bits oder weniger Perioden nehmen</translation>
    </message>
    <message>
        <source>there are more periods than samples</source>
        <translation>es sind mehr Perioden als Abtastwerte</translation>
    </message>
    <message>
        <source>this multisine has too many harmonics: take fewer samples or a longer bit</source>
        <translation>dieser Multisinus hat zu viele Oberschwingungen: weniger Abtastwerte oder ein längeres Bit nehmen</translation>
    </message>
    <message>
        <source>bias and peak are too large</source>
        <translation>Grundkraft und Spitze sind zu groß</translation>
    </message>
    <message>
        <source>expected three numbers from 0 to %1 with commas between: m,b,k</source>
        <translation>erwartet: drei Zahlen von 0 bis %1, durch Kommas getrennt: m,b,k</translation>
    </message>
    <message>
        <source>expected a number from 0 to %1</source>
        <translation>erwartet: eine Zahl von 0 bis %1</translation>
    </message>
    <message>
        <source>the channels differ in length, or hold numbers that are not finite, or the sample time is not above zero</source>
        <translation>die Kanäle sind verschieden lang oder enthalten Zahlen, die nicht endlich sind, oder die Abtastzeit ist nicht größer als null</translation>
    </message>
    <message>
        <source>%1 samples of approach and touch and %2 of release were left out; %3 samples of squeeze remain</source>
        <translation>%1 Abtastwerte von Annähern und Berühren und %2 vom Loslassen wurden ausgelassen; %3 Abtastwerte vom Drücken bleiben</translation>
    </message>
    <message>
        <source>the device&apos;s clock runs at %1 s a sample instead of %2 s (%3 %); its own time was used</source>
        <translation>die Uhr des Geräts läuft mit %L1 s je Abtastwert statt %L2 s (%3 %); seine eigene Zeit wurde verwendet</translation>
    </message>
    <message>
        <source>. That is much for a clock: check the sample time</source>
        <translation>. Das ist viel für eine Uhr: die Abtastzeit prüfen</translation>
    </message>
    <message>
        <source>time stamps and sample numbers contradict each other in %1 places: the device&apos;s clock was set, or the device started again. The longest part between them was used.</source>
        <translation>Zeitstempel und Abtastnummern widersprechen sich an %1 Stellen: Die Uhr des Geräts wurde gestellt, oder das Gerät startete neu. Der längste Abschnitt dazwischen wurde verwendet.</translation>
    </message>
    <message>
        <source>the samples jitter by %1 % of the sample time and were taken as regular</source>
        <translation>die Abtastwerte schwanken um %1 % der Abtastzeit und wurden als regelmäßig genommen</translation>
    </message>
    <message>
        <source>the samples jitter by %1 % of the sample time; force and position were put on a regular grid</source>
        <translation>die Abtastwerte schwanken um %1 % der Abtastzeit; Kraft und Weg wurden auf ein regelmäßiges Raster gebracht</translation>
    </message>
    <message>
        <source>. That is too much for an exact correction: let the device sample more regularly</source>
        <translation>. Das ist zu viel für eine genaue Korrektur: das Gerät regelmäßiger abtasten lassen</translation>
    </message>
    <message>
        <source>%1 samples are missing in %2 places; the force there counts as unknown</source>
        <translation>%1 Abtastwerte fehlen an %2 Stellen; die Kraft gilt dort als unbekannt</translation>
    </message>
    <message>
        <source>too many samples are missing to bridge all gaps; %1 of the %2 samples there are were used. Check the cable and the load of the computer, then squeeze again.</source>
        <translation>zu viele Abtastwerte fehlen, um alle Lücken zu überbrücken; %1 der %2 vorhandenen wurden verwendet. Kabel und Auslastung des Rechners prüfen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the gripper left the object for %1 samples (%2 %), since it can push but not pull; they were left out. Squeeze with more bias.</source>
        <translation>der Greifer verließ das Objekt für %1 Abtastwerte (%2 %), da er drücken, aber nicht ziehen kann; sie wurden ausgelassen. Mit mehr Grundkraft drücken.</translation>
    </message>
    <message>
        <source>the frame&apos;s share of the position, %1 position units per force unit, was taken away</source>
        <translation>der Anteil des Gestells am Weg, %1 Wegeinheiten je Krafteinheit, wurde abgezogen</translation>
    </message>
    <message>
        <source>samples at the end of a sensor&apos;s range: %1 by the device&apos;s word, %2 of force and %3 of position by their look. Squeeze with less force.</source>
        <translation>Abtastwerte am Ende des Messbereichs: %1 laut Gerät, %2 der Kraft und %3 des Wegs dem Aussehen nach. Mit weniger Kraft drücken.</translation>
    </message>
    <message>
        <source>the position comes in steps of %1, %2 % of its range and more than twice its noise: m, b and k may be off by up to %3 %</source>
        <translation>der Weg kommt in Stufen von %1, das sind %2 % seines Bereichs und mehr als das Doppelte seines Rauschens: m, b und k können um bis zu %3 % danebenliegen</translation>
    </message>
    <message>
        <source>bytes that are not UTF-8: </source>
        <translation>Bytes, die nicht UTF-8 sind: </translation>
    </message>
    <message>
        <source>expected a text file in UTF-8</source>
        <translation>erwartet: eine Textdatei in UTF-8</translation>
    </message>
    <message>
        <source>found no header line</source>
        <translation>gefunden: keine Kopfzeile</translation>
    </message>
    <message>
        <source>expected column names such as &quot;time_s,force,position&quot;</source>
        <translation>erwartet: Spaltennamen wie &quot;time_s,force,position&quot;</translation>
    </message>
    <message>
        <source>found no rows behind the header</source>
        <translation>gefunden: keine Zeilen nach der Kopfzeile</translation>
    </message>
    <message>
        <source>expected one row a sample</source>
        <translation>erwartet: eine Zeile je Abtastwert</translation>
    </message>
    <message>
        <source>found a recording of version </source>
        <translation>gefunden: eine Aufnahme der Version </translation>
    </message>
    <message>
        <source>expected version 1</source>
        <translation>erwartet: Version 1</translation>
    </message>
    <message>
        <source>found the sample time </source>
        <translation>gefunden: Abtastzeit </translation>
    </message>
    <message>
        <source>found the force lag </source>
        <translation>gefunden: Zeitversatz der Kraft </translation>
    </message>
    <message>
        <source>found the force hold </source>
        <translation>gefunden: Kraftverlauf </translation>
    </message>
    <message>
        <source>expected zoh or foh</source>
        <translation>erwartet: zoh oder foh</translation>
    </message>
    <message>
        <source>found no column &quot;%1&quot;</source>
        <translation>gefunden: keine Spalte &quot;%1&quot;</translation>
    </message>
    <message>
        <source>expected one of the columns there are: </source>
        <translation>erwartet: eine der vorhandenen Spalten: </translation>
    </message>
    <message>
        <source>found the column &quot;%1&quot; twice</source>
        <translation>gefunden: zweimal die Spalte &quot;%1&quot;</translation>
    </message>
    <message>
        <source>expected each column once</source>
        <translation>erwartet: jede Spalte einmal</translation>
    </message>
    <message>
        <source>found a quote that is not closed</source>
        <translation>gefunden: ein nicht geschlossenes Anführungszeichen</translation>
    </message>
    <message>
        <source>expected column names</source>
        <translation>erwartet: Spaltennamen</translation>
    </message>
    <message>
        <source>expected a finite number</source>
        <translation>erwartet: eine endliche Zahl</translation>
    </message>
    <message>
        <source>expected a row of numbers</source>
        <translation>erwartet: eine Zeile mit Zahlen</translation>
    </message>
    <message>
        <source>found a row of %1 fields</source>
        <translation>gefunden: eine Zeile mit %1 Feldern</translation>
    </message>
    <message>
        <source>expected %1, as in the header</source>
        <translation>erwartet: %1, wie in der Kopfzeile</translation>
    </message>
    <message>
        <source>found the time </source>
        <translation>gefunden: die Zeit </translation>
    </message>
    <message>
        <source>expected a time later than the row before</source>
        <translation>erwartet: eine spätere Zeit als in der Zeile davor</translation>
    </message>
    <message>
        <source>expected a whole number from 0 up</source>
        <translation>erwartet: eine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>expected a whole number from 0 to 65535</source>
        <translation>erwartet: eine ganze Zahl von 0 bis 65535</translation>
    </message>
    <message>
        <source>found neither a time_s column nor &quot;# sample_time_s:&quot;</source>
        <translation>gefunden: weder eine Spalte time_s noch &quot;# sample_time_s:&quot;</translation>
    </message>
    <message>
        <source>expected one of them, or the sample time as an option</source>
        <translation>erwartet: eines davon oder die Abtastzeit als Option</translation>
    </message>
    <message>
        <source>found one row only</source>
        <translation>gefunden: nur eine Zeile</translation>
    </message>
    <message>
        <source>expected a second one, to tell the sample time</source>
        <translation>erwartet: eine zweite, um die Abtastzeit zu bestimmen</translation>
    </message>
    <message>
        <source>expected steps of the sample time, %1 s</source>
        <translation>erwartet: Schritte der Abtastzeit, %1 s</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>read the calibrations</source>
        <translation>Kalibrierungen lesen</translation>
    </message>
    <message>
        <source>a point reads &quot;%1&quot;</source>
        <translation>ein Punkt lautet &quot;%1&quot;</translation>
    </message>
    <message>
        <source>a channel is neither of the two</source>
        <translation>ein Kanal ist keiner von beiden</translation>
    </message>
    <message>
        <source>store the calibration</source>
        <translation>Kalibrierung speichern</translation>
    </message>
    <message>
        <source>read its versions</source>
        <translation>Versionen lesen</translation>
    </message>
    <message>
        <source>record the change</source>
        <translation>Änderung festhalten</translation>
    </message>
    <message>
        <source>another program kept it locked for %1 s</source>
        <translation>ein anderes Programm hielt sie %1 s lang gesperrt</translation>
    </message>
    <message>
        <source>the file or its folder is write-protected</source>
        <translation>die Datei oder ihr Ordner ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>der Datenträger meldet einen Fehler</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>the file or its folder is missing or may not be opened or written</source>
        <translation>die Datei oder ihr Ordner fehlt oder darf nicht geöffnet oder beschrieben werden</translation>
    </message>
    <message>
        <source>no file is named</source>
        <translation>keine Datei ist genannt</translation>
    </message>
    <message>
        <source>it is not a library but a file of another kind</source>
        <translation>es ist keine Bibliothek, sondern eine Datei anderer Art</translation>
    </message>
    <message>
        <source>Qt&apos;s SQLite driver is not installed</source>
        <translation>der SQLite-Treiber von Qt ist nicht installiert</translation>
    </message>
    <message>
        <source>be opened</source>
        <translation>öffnen</translation>
    </message>
    <message>
        <source>be opened for writing</source>
        <translation>zum Schreiben öffnen</translation>
    </message>
    <message>
        <source>its file system cannot keep a write-ahead log</source>
        <translation>ihr Dateisystem kann kein Write-Ahead-Log führen</translation>
    </message>
    <message>
        <source>be read</source>
        <translation>lesen</translation>
    </message>
    <message>
        <source>store the squeeze</source>
        <translation>Druckversuch speichern</translation>
    </message>
    <message>
        <source>read the squeeze</source>
        <translation>Druckversuch lesen</translation>
    </message>
    <message>
        <source>store the estimate</source>
        <translation>Schätzung speichern</translation>
    </message>
    <message>
        <source>read the squeezes</source>
        <translation>Druckversuche lesen</translation>
    </message>
    <message>
        <source>A squeeze of a type needs an estimate.</source>
        <translation>Ein Druckversuch eines Typs braucht eine Schätzung.</translation>
    </message>
    <message>
        <source>squeeze with the key %1</source>
        <translation>Druckversuch mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>read the inspections</source>
        <translation>Prüfungen lesen</translation>
    </message>
    <message>
        <source>store the inspection</source>
        <translation>Prüfung speichern</translation>
    </message>
    <message>
        <source>drop the squeeze</source>
        <translation>Druckversuch verwerfen</translation>
    </message>
    <message>
        <source>The squeeze of an inspection belongs to no type.</source>
        <translation>Der Druckversuch einer Prüfung gehört zu keinem Typ.</translation>
    </message>
    <message>
        <source>This gripper has no serial number to keep what was measured under.</source>
        <translation>Dieser Greifer hat keine Seriennummer, unter der das Gemessene abzulegen wäre.</translation>
    </message>
    <message>
        <source>A number that was measured of the gripper is not finite.</source>
        <translation>Eine am Greifer gemessene Zahl ist nicht endlich.</translation>
    </message>
    <message>
        <source>store what was measured of the gripper</source>
        <translation>am Greifer Gemessenes speichern</translation>
    </message>
    <message>
        <source>This gripper has no serial number to keep its calibration under.</source>
        <translation>Dieser Greifer hat keine Seriennummer, unter der seine Kalibrierung abzulegen wäre.</translation>
    </message>
    <message>
        <source>A calibration needs the unit of its channel and the time it was taken.</source>
        <translation>Eine Kalibrierung braucht die Einheit ihres Kanals und den Zeitpunkt der Aufnahme.</translation>
    </message>
    <message>
        <source>A calibration needs a date until which it holds.</source>
        <translation>Eine Kalibrierung braucht ein Datum, bis zu dem sie gilt.</translation>
    </message>
    <message>
        <source>1 squeeze</source>
        <translation>1 Druckversuch</translation>
    </message>
    <message>
        <source>%1 squeezes</source>
        <translation>%1 Druckversuche</translation>
    </message>
    <message>
        <source>%1 was added as a new type.</source>
        <translation>%1 kam als neuer Typ hinzu.</translation>
    </message>
    <message>
        <source>%1 was enrolled with %2 more.</source>
        <translation>%1 wurde eingelernt: weitere %2.</translation>
    </message>
    <message>
        <source>%2 of %1 was dropped.</source>
        <translation>Von %1 verworfen: %2.</translation>
    </message>
    <message>
        <source>The recipe of %1 was changed.</source>
        <translation>Das Rezept von %1 wurde geändert.</translation>
    </message>
    <message>
        <source>%1 was approved.</source>
        <translation>%1 wurde freigegeben.</translation>
    </message>
    <message>
        <source>%1 was renamed %2.</source>
        <translation>%1 heißt jetzt %2.</translation>
    </message>
    <message>
        <source>%1 was merged into %2, with %3.</source>
        <translation>%1 wurde mit %2 zusammengeführt: %3.</translation>
    </message>
    <message>
        <source>%3 of %1 became the new type %2.</source>
        <translation>Von %1 wurde abgetrennt: %3, als neuer Typ %2.</translation>
    </message>
    <message>
        <source>%1 was retired: it is no longer recognised.</source>
        <translation>%1 ist außer Gebrauch: wird nicht mehr erkannt.</translation>
    </message>
    <message>
        <source>%1 was put back into use.</source>
        <translation>%1 ist wieder in Gebrauch.</translation>
    </message>
    <message>
        <source>The library was put back to version %1.</source>
        <translation>Die Bibliothek ist wieder auf dem Stand von Version %1.</translation>
    </message>
    <message>
        <source>The paper&apos;s example types were added.</source>
        <translation>Die Beispieltypen der Veröffentlichung kamen hinzu.</translation>
    </message>
    <message>
        <source>Say why: the reason is kept with the change.</source>
        <translation>Den Grund nennen: Er wird mit der Änderung aufbewahrt.</translation>
    </message>
    <message>
        <source>A type cannot be merged into itself.</source>
        <translation>Ein Typ kann nicht mit sich selbst zusammengeführt werden.</translation>
    </message>
    <message>
        <source>Only accepted squeezes of %1 can be taken out of it.</source>
        <translation>Nur angenommene Druckversuche von %1 können herausgenommen werden.</translation>
    </message>
    <message>
        <source>Some squeezes of %1 must go into the new type, and some must stay; to change the name of all, rename it.</source>
        <translation>Einige Druckversuche von %1 müssen zum neuen Typ gehen und einige bleiben; sollen alle anders heißen, den Typ umbenennen.</translation>
    </message>
    <message>
        <source>add the type</source>
        <translation>Typ hinzufügen</translation>
    </message>
    <message>
        <source>store the recipe</source>
        <translation>Rezept speichern</translation>
    </message>
    <message>
        <source>approve the type</source>
        <translation>Typ freigeben</translation>
    </message>
    <message>
        <source>rename the type</source>
        <translation>Typ umbenennen</translation>
    </message>
    <message>
        <source>merge the types</source>
        <translation>Typen zusammenführen</translation>
    </message>
    <message>
        <source>split the type</source>
        <translation>Typ aufteilen</translation>
    </message>
    <message>
        <source>retire the type</source>
        <translation>Typ außer Gebrauch nehmen</translation>
    </message>
    <message>
        <source>put the type back into use</source>
        <translation>Typ wieder in Gebrauch nehmen</translation>
    </message>
    <message>
        <source>%1 is in use already.</source>
        <translation>%1 ist bereits in Gebrauch.</translation>
    </message>
    <message>
        <source>The library has no version %1; its newest is %2.</source>
        <translation>Die Bibliothek hat keine Version %1; die neueste ist %2.</translation>
    </message>
    <message>
        <source>Types and squeezes are as they were at version %1.</source>
        <translation>Typen und Druckversuche sind wie in Version %1.</translation>
    </message>
    <message>
        <source>restore version %1</source>
        <translation>Version %1 wiederherstellen</translation>
    </message>
    <message>
        <source>read what is known of the gripper</source>
        <translation>lesen, was über den Greifer bekannt ist</translation>
    </message>
    <message>
        <source>place the squeeze</source>
        <translation>Druckversuch zuordnen</translation>
    </message>
    <message>
        <source>it does not begin like one</source>
        <translation>sie beginnt nicht wie eine</translation>
    </message>
    <message>
        <source>its layout has version %1; this program knows up to %2</source>
        <translation>ihr Aufbau hat Version %1; dieses Programm kennt bis zu %2</translation>
    </message>
    <message>
        <source>its hold is not known</source>
        <translation>ihr Kraftverlauf ist nicht bekannt</translation>
    </message>
    <message>
        <source>it is shorter or longer than it says</source>
        <translation>sie ist kürzer oder länger, als sie sagt</translation>
    </message>
    <message>
        <source>store the recording</source>
        <translation>Aufnahme speichern</translation>
    </message>
    <message>
        <source>read the recording</source>
        <translation>Aufnahme lesen</translation>
    </message>
    <message>
        <source>recording of the squeeze %1</source>
        <translation>Aufnahme des Druckversuchs %1</translation>
    </message>
    <message>
        <source>The recording of the squeeze %1</source>
        <translation>Die Aufnahme des Druckversuchs %1</translation>
    </message>
    <message>
        <source>its bytes are not those that were stored</source>
        <translation>ihre Bytes sind nicht die gespeicherten</translation>
    </message>
    <message>
        <source>change the type</source>
        <translation>Typ ändern</translation>
    </message>
    <message>
        <source>read the types</source>
        <translation>Typen lesen</translation>
    </message>
    <message>
        <source>read the recipe</source>
        <translation>Rezept lesen</translation>
    </message>
    <message>
        <source>The recipe holds a number that is not finite.</source>
        <translation>Das Rezept enthält eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>type with the key %1</source>
        <translation>Typ mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>%1 is retired. Put it back into use first, or choose another type.</source>
        <translation>%1 ist außer Gebrauch. Erst wieder in Gebrauch nehmen oder einen anderen Typ wählen.</translation>
    </message>
    <message>
        <source>A type needs a name.</source>
        <translation>Ein Typ braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is already a type called %1; it is retired.</source>
        <translation>Einen Typ namens %1 gibt es schon; er ist außer Gebrauch.</translation>
    </message>
    <message>
        <source>There is already a type called %1.</source>
        <translation>Einen Typ namens %1 gibt es schon.</translation>
    </message>
    <message>
        <source>say what it is</source>
        <translation>sagen, was er ist</translation>
    </message>
    <message>
        <source>feature report 0x%1: %2</source>
        <translation>Feature-Report 0x%1: %2</translation>
    </message>
    <message>
        <source>disarm</source>
        <translation>entschärfen</translation>
    </message>
    <message>
        <source>confirm the stop</source>
        <translation>den Stopp bestätigen</translation>
    </message>
    <message>
        <source>take the limits of the squeeze</source>
        <translation>die Grenzen des Druckversuchs übernehmen</translation>
    </message>
    <message>
        <source>take the force signal</source>
        <translation>das Kraftsignal übernehmen</translation>
    </message>
    <message>
        <source>start the squeeze</source>
        <translation>den Druckversuch beginnen</translation>
    </message>
    <message>
        <source>end the squeeze early</source>
        <translation>den Druckversuch früh beenden</translation>
    </message>
    <message>
        <source>further sample at %1: it was replayed to its end</source>
        <translation>weiterer Abtastwert von %1: bis zum Ende wiedergegeben</translation>
    </message>
    <message>
        <source>it was unplugged or switched off</source>
        <translation>er wurde abgezogen oder ausgeschaltet</translation>
    </message>
    <message>
        <source>it sent nothing for a second</source>
        <translation>er sendete eine Sekunde lang nichts</translation>
    </message>
    <message>
        <source>it restarted</source>
        <translation>er startete neu</translation>
    </message>
    <message>
        <source>Device address: %1 is not understood; %2.</source>
        <translation>Geräteadresse: %1 ist nicht verständlich; %2.</translation>
    </message>
    <message>
        <source>%1 is a number from %2 to %3</source>
        <translation>%1 ist eine Zahl von %2 bis %3</translation>
    </message>
    <message>
        <source>replug:S needs unplug:S beside it</source>
        <translation>replug:S braucht unplug:S daneben</translation>
    </message>
    <message>
        <source>seed is a whole number from 0 on</source>
        <translation>seed ist eine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>a second fault=</source>
        <translation>ein zweites fault=</translation>
    </message>
    <message>
        <source>faults stand behind one fault=, with commas between</source>
        <translation>Fehler stehen hinter einem einzigen fault=, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>behind virtual: comes nothing, or ? and options such as object=A&amp;seed=7</source>
        <translation>hinter virtual: kommt nichts oder ? und Optionen wie object=A&amp;seed=7</translation>
    </message>
    <message>
        <source>an option is name=value</source>
        <translation>eine Option ist name=wert</translation>
    </message>
    <message>
        <source>a vendor or product number has up to four hexadecimal digits, such as 1209</source>
        <translation>eine Hersteller- oder Produktnummer hat bis zu vier Hexadezimalziffern, etwa 1209</translation>
    </message>
    <message>
        <source>behind hid: the options are port=PORT, profile=FILE and capture=FILE</source>
        <translation>hinter hid: sind die Optionen port=PORT, profile=FILE und capture=FILE</translation>
    </message>
    <message>
        <source>hid: stands alone, or as hid:1209:0001 or hid:1209:0001:SERIAL</source>
        <translation>hid: steht allein oder als hid:1209:0001 oder hid:1209:0001:SERIAL</translation>
    </message>
    <message>
        <source>an address is virtual: or virtual:?object=A&amp;seed=7, hid: or hid:1209:0001:SERIAL, or replay:FILE</source>
        <translation>eine Adresse ist virtual: oder virtual:?object=A&amp;seed=7, hid: oder hid:1209:0001:SERIAL oder replay:FILE</translation>
    </message>
    <message>
        <source>Type this in a terminal, then it is connected by itself:
</source>
        <translation>Dies in ein Terminal eingeben, dann wird er von selbst verbunden:
</translation>
    </message>
    <message>
        <source>Plug it in and switch it on, or try virtual: without hardware.</source>
        <translation>Anstecken und einschalten oder ohne Hardware virtual: versuchen.</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>The self-test is under way. Wait for its end.</source>
        <translation>Der Selbsttest läuft. Das Ende abwarten.</translation>
    </message>
    <message>
        <source>No gripper is connected. Connect one, then test it.</source>
        <translation>Kein Greifer ist verbunden. Erst verbinden, dann prüfen.</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>keine Abtastwerte</translation>
    </message>
    <message>
        <source>always the same number</source>
        <translation>immer dieselbe Zahl</translation>
    </message>
    <message>
        <source>Either it is quieter than one count, or it is stuck: touch the gripper and see whether the number moves.</source>
        <translation>Entweder ist er ruhiger als eine Stufe, oder er hängt: den Greifer berühren und sehen, ob sich die Zahl bewegt.</translation>
    </message>
    <message>
        <source>at most %1 %2</source>
        <translation>höchstens %1 %2</translation>
    </message>
    <message>
        <source>Take away what shakes the gripper and what it holds, then test again; if it stays, check the sensor&apos;s wiring and shielding.</source>
        <translation>Entfernen, was den Greifer erschüttert und was er hält, dann erneut prüfen; bleibt es so, Verdrahtung und Schirmung des Sensors prüfen.</translation>
    </message>
    <message>
        <source>What it says of itself</source>
        <translation>Seine eigenen Angaben</translation>
    </message>
    <message>
        <source>Plug the gripper in again. If it stays, its firmware does not answer as devices/PROTOCOL.md asks.</source>
        <translation>Den Greifer neu anstecken. Bleibt es so, antwortet seine Firmware nicht, wie devices/PROTOCOL.md verlangt.</translation>
    </message>
    <message>
        <source>all read, checksums right</source>
        <translation>alles gelesen, Prüfsummen richtig</translation>
    </message>
    <message>
        <source>identity, measurement and limits read, checksums right</source>
        <translation>Identität, Messgrößen und Grenzen gelesen, Prüfsummen richtig</translation>
    </message>
    <message>
        <source>said by a profile or a file, not by the gripper</source>
        <translation>von Profil oder Datei angegeben, nicht vom Greifer</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>%1 samples a second within %2 %</source>
        <translation>%1 Abtastwerte je Sekunde auf %2 %</translation>
    </message>
    <message>
        <source>Check the cable and the load of the computer. If it stays, the sample time that the gripper states is wrong.</source>
        <translation>Kabel und Auslastung des Rechners prüfen. Bleibt es so, ist die vom Greifer genannte Abtastzeit falsch.</translation>
    </message>
    <message>
        <source>nothing came</source>
        <translation>nichts kam an</translation>
    </message>
    <message>
        <source>%1 samples in %2 reports a second</source>
        <translation>%1 Abtastwerte in %2 Reports je Sekunde</translation>
    </message>
    <message>
        <source>Nothing lost</source>
        <translation>Nichts verloren</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 Abtastwerte verloren</translation>
    </message>
    <message>
        <source>%1 reports twice</source>
        <translation>%1 Reports doppelt</translation>
    </message>
    <message>
        <source>%1 samples dropped here</source>
        <translation>%1 Abtastwerte hier verworfen</translation>
    </message>
    <message>
        <source>0 lost, twice, damaged or silent</source>
        <translation>0 verloren, doppelt, beschädigt oder stumm</translation>
    </message>
    <message>
        <source>Try a shorter cable and another port, without a hub; close programs that keep the computer busy.</source>
        <translation>Ein kürzeres Kabel und einen anderen Anschluss versuchen, ohne Hub; Programme schließen, die den Rechner beschäftigen.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>no jump, within %1 ppm of the computer&apos;s</source>
        <translation>kein Sprung, auf %1 ppm wie die des Rechners</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Check the gripper&apos;s power supply; if it stays, its firmware keeps time badly.</source>
        <translation>Die Stromversorgung des Greifers prüfen; bleibt es so, hält seine Firmware die Zeit schlecht ein.</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>no fault, nothing saturated</source>
        <translation>kein Fehler, nichts übersteuert</translation>
    </message>
    <message>
        <source>Open the gripper and take out what it holds; if it stays, it needs service.</source>
        <translation>Den Greifer öffnen und herausnehmen, was er hält; bleibt es so, braucht er Wartung.</translation>
    </message>
    <message>
        <source>Force at rest</source>
        <translation>Kraft in Ruhe</translation>
    </message>
    <message>
        <source>Position at rest</source>
        <translation>Weg in Ruhe</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>this gripper takes no commands</source>
        <translation>dieser Greifer nimmt keine Befehle an</translation>
    </message>
    <message>
        <source>answered within %1 ms</source>
        <translation>Antwort innerhalb von %1 ms</translation>
    </message>
    <message>
        <source>answered in %1 ms</source>
        <translation>Antwort nach %1 ms</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>Do not squeeze with this gripper until it answers: check the cable, then its firmware.</source>
        <translation>Mit diesem Greifer nicht drücken, bis er antwortet: Kabel prüfen, dann seine Firmware.</translation>
    </message>
    <message>
        <source>be asked</source>
        <translation>gefragt werden</translation>
    </message>
    <message>
        <source>it is known by a profile, and only listened to</source>
        <translation>er ist durch ein Profil bekannt und wird nur abgehört</translation>
    </message>
    <message>
        <source>uN, mN, N or kN</source>
        <translation>uN, mN, N oder kN</translation>
    </message>
    <message>
        <source>nm, um, mm, cm or m</source>
        <translation>nm, um, mm, cm oder m</translation>
    </message>
    <message>
        <source>the numbers of another gripper: this one speaks Gripscope&apos;s own protocol and needs no profile</source>
        <translation>die Nummern eines anderen Greifers: Dieser spricht das eigene Protokoll von Gripscope und braucht kein Profil</translation>
    </message>
    <message>
        <source>%1 samples without a stride</source>
        <translation>%1 Abtastwerte ohne Schrittweite</translation>
    </message>
    <message>
        <source>a stride, the bytes from one sample to the next</source>
        <translation>eine Schrittweite, die Bytes von einem Abtastwert zum nächsten</translation>
    </message>
    <message>
        <source>bits of an f32</source>
        <translation>Bits eines f32</translation>
    </message>
    <message>
        <source>a whole number type, or neither first_bit nor bits</source>
        <translation>ein ganzzahliger Typ oder weder first_bit noch bits</translation>
    </message>
    <message>
        <source>bits %1 to %2</source>
        <translation>Bits %1 bis %2</translation>
    </message>
    <message>
        <source>bits within the %1 of %2, 0 to %3</source>
        <translation>Bits innerhalb der %1 von %2, 0 bis %3</translation>
    </message>
    <message>
        <source>1 or more: byte 0 is the report ID</source>
        <translation>1 oder mehr: Byte 0 ist die Report-ID</translation>
    </message>
    <message>
        <source>%1, so that the field ends behind byte %2</source>
        <translation>%1, sodass das Feld nach Byte %2 endet</translation>
    </message>
    <message>
        <source>a field that ends at byte %1 at the latest, as the report is %2 bytes long</source>
        <translation>ein Feld, das spätestens mit Byte %1 endet, da der Report %2 Bytes lang ist</translation>
    </message>
    <message>
        <source>a unit of %1: %2</source>
        <translation>eine Einheit von %1: %2</translation>
    </message>
    <message>
        <source>a number other than 0: all values would be the same</source>
        <translation>eine andere Zahl als 0: Sonst wären alle Werte gleich</translation>
    </message>
    <message>
        <source>less than saturates_above, which is %1</source>
        <translation>weniger als saturates_above, das %1 ist</translation>
    </message>
    <message>
        <source>u8, u16, u24 or u32: it counts upwards</source>
        <translation>u8, u16, u24 oder u32: Es zählt aufwärts</translation>
    </message>
    <message>
        <source>at least %1 bits</source>
        <translation>mindestens %1 Bits</translation>
    </message>
    <message>
        <source>a clock that comes round every %1 s</source>
        <translation>eine Uhr, die alle %1 s umläuft</translation>
    </message>
    <message>
        <source>one that takes at least four reports, %1 s</source>
        <translation>eine, die mindestens vier Reports braucht, %1 s</translation>
    </message>
    <message>
        <source>a bit of the %1, 0 to %2</source>
        <translation>ein Bit von %1, 0 bis %2</translation>
    </message>
    <message>
        <source>%1, where %2 has bits already</source>
        <translation>%1, wo %2 schon Bits hat</translation>
    </message>
    <message>
        <source>the sample before</source>
        <translation>der Abtastwert davor</translation>
    </message>
    <message>
        <source>bits of its own, or &quot;shares_bytes&quot;: true where that is meant</source>
        <translation>eigene Bits oder &quot;shares_bytes&quot;: true, wo das gewollt ist</translation>
    </message>
    <message>
        <source>a JSON document</source>
        <translation>ein JSON-Dokument</translation>
    </message>
    <message>
        <source>an object in braces</source>
        <translation>ein Objekt in geschweiften Klammern</translation>
    </message>
    <message>
        <source>profile for a gripper %1: write one (the manual&apos;s page on profiles says how) and put it into %2, or name it behind the address: ?profile=FILE</source>
        <translation>Profil für einen Greifer %1: eines schreiben (die Profilseite des Handbuchs sagt, wie) und in %2 ablegen oder hinter der Adresse nennen: ?profile=FILE</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>A replay has no bytes to watch; name a gripper.</source>
        <translation>Eine Wiedergabe hat keine Bytes zum Beobachten; einen Greifer nennen.</translation>
    </message>
    <message>
        <source>profile for %1: it is no gripper of another maker</source>
        <translation>Profil für %1: Das ist kein Greifer eines anderen Herstellers</translation>
    </message>
    <message>
        <source>that address</source>
        <translation>diese Adresse</translation>
    </message>
    <message>
        <source>It is unplugged; its faults plug it in again by themselves.</source>
        <translation>Er ist abgezogen; seine Fehler stecken ihn von selbst wieder an.</translation>
    </message>
    <message>
        <source>it does not speak Gripscope&apos;s protocol</source>
        <translation>er spricht das Protokoll von Gripscope nicht</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>it was done before</source>
        <translation>es war schon erledigt</translation>
    </message>
    <message>
        <source>it is not armed</source>
        <translation>er ist nicht scharf</translation>
    </message>
    <message>
        <source>a squeeze is running</source>
        <translation>ein Druckversuch läuft</translation>
    </message>
    <message>
        <source>a value is above a limit</source>
        <translation>ein Wert liegt über einer Grenze</translation>
    </message>
    <message>
        <source>a value is outside its range</source>
        <translation>ein Wert liegt außerhalb seines Bereichs</translation>
    </message>
    <message>
        <source>a part of the force signal is missing</source>
        <translation>ein Teil des Kraftsignals fehlt</translation>
    </message>
    <message>
        <source>the force signal arrived damaged</source>
        <translation>das Kraftsignal kam beschädigt an</translation>
    </message>
    <message>
        <source>this squeeze was started before</source>
        <translation>dieser Druckversuch wurde schon begonnen</translation>
    </message>
    <message>
        <source>it does not know this command</source>
        <translation>er kennt diesen Befehl nicht</translation>
    </message>
    <message>
        <source>the checksum differs</source>
        <translation>die Prüfsumme weicht ab</translation>
    </message>
    <message>
        <source>the report is of an unknown kind</source>
        <translation>der Report ist von unbekannter Art</translation>
    </message>
    <message>
        <source>a field is outside its range</source>
        <translation>ein Feld liegt außerhalb seines Bereichs</translation>
    </message>
    <message>
        <source>report sequence</source>
        <translation>Report-Nummer</translation>
    </message>
    <message>
        <source>first sample</source>
        <translation>erster Abtastwert</translation>
    </message>
    <message>
        <source>device time</source>
        <translation>Gerätezeit</translation>
    </message>
    <message>
        <source>force %1, position %2 counts</source>
        <translation>Kraft %1, Weg %2 Stufen</translation>
    </message>
    <message>
        <source>largest force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>longest travel</source>
        <translation>längster Weg</translation>
    </message>
    <message>
        <source>from index</source>
        <translation>ab Index</translation>
    </message>
    <message>
        <source>their CRC</source>
        <translation>ihr CRC</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>one count of force</source>
        <translation>eine Stufe der Kraft</translation>
    </message>
    <message>
        <source>one count of position</source>
        <translation>eine Stufe des Wegs</translation>
    </message>
    <message>
        <source>sample time</source>
        <translation>Abtastzeit</translation>
    </message>
    <message>
        <source>position later by</source>
        <translation>Weg später um</translation>
    </message>
    <message>
        <source>force between samples</source>
        <translation>Kraft zwischen Abtastwerten</translation>
    </message>
    <message>
        <source>a straight line</source>
        <translation>eine Gerade</translation>
    </message>
    <message>
        <source>takes commands</source>
        <translation>nimmt Befehle an</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>longest excitation</source>
        <translation>längste Anregung</translation>
    </message>
    <message>
        <source>force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>travel limit</source>
        <translation>Weggrenze</translation>
    </message>
    <message>
        <source>force saturated</source>
        <translation>Kraft übersteuert</translation>
    </message>
    <message>
        <source>position saturated</source>
        <translation>Weg übersteuert</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Datenstrom</translation>
    </message>
    <message>
        <source>Acknowledgement</source>
        <translation>Bestätigung</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identität</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messgrößen</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Entschärfen</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Lebenszeichen</translation>
    </message>
    <message>
        <source>Set limits</source>
        <translation>Grenzen setzen</translation>
    </message>
    <message>
        <source>Upload</source>
        <translation>Hochladen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>unknown report 0x%1</source>
        <translation>unbekannter Report 0x%1</translation>
    </message>
    <message>
        <source>empty report</source>
        <translation>leerer Report</translation>
    </message>
    <message>
        <source>list the kept captures</source>
        <translation>die aufbewahrten Aufzeichnungen auflisten</translation>
    </message>
    <message>
        <source>not closed: it is being written, or its program ended; %1 whole records, %2 bytes behind them</source>
        <translation>nicht abgeschlossen: Sie wird geschrieben, oder ihr Programm endete; %1 ganze Einträge, %2 Bytes dahinter</translation>
    </message>
    <message>
        <source>changed since it was closed: its SHA-256 is not the one listed</source>
        <translation>seit dem Abschließen verändert: Ihr SHA-256 ist nicht der aufgelistete</translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation>ein anderes Programm hält %1</translation>
    </message>
    <message>
        <source>it cannot be removed to make room for newer captures</source>
        <translation>sie lässt sich nicht entfernen, um Platz für neuere Aufzeichnungen zu schaffen</translation>
    </message>
    <message>
        <source>this is no Gripscope capture</source>
        <translation>das ist keine Aufzeichnung von Gripscope</translation>
    </message>
    <message>
        <source>expected GSCAP, version 1 or 2</source>
        <translation>erwartet: GSCAP, Version 1 oder 2</translation>
    </message>
    <message>
        <source>a capture of version %1</source>
        <translation>eine Aufzeichnung der Version %1</translation>
    </message>
    <message>
        <source>expected version 1 or 2; a newer program reads it</source>
        <translation>erwartet: Version 1 oder 2; ein neueres Programm liest sie</translation>
    </message>
    <message>
        <source>a record of kind %1</source>
        <translation>ein Eintrag der Art %1</translation>
    </message>
    <message>
        <source>expected a kind from 0 to %1</source>
        <translation>erwartet: eine Art von 0 bis %1</translation>
    </message>
    <message>
        <source>a report of %1 bytes</source>
        <translation>ein Report von %1 Bytes</translation>
    </message>
    <message>
        <source>expected at most %1</source>
        <translation>erwartet: höchstens %1</translation>
    </message>
    <message>
        <source>a time before that of the record in front</source>
        <translation>eine Zeit vor der des Eintrags davor</translation>
    </message>
    <message>
        <source>expected times in order</source>
        <translation>erwartet: Zeiten der Reihe nach</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>sie ist geschlossen</translation>
    </message>
    <message>
        <source>it was removed while it was written</source>
        <translation>sie wurde beim Schreiben entfernt</translation>
    </message>
    <message>
        <source>no report of a gripper</source>
        <translation>kein Report eines Greifers</translation>
    </message>
    <message>
        <source>no feature report 0x%1</source>
        <translation>kein Feature-Report 0x%1</translation>
    </message>
    <message>
        <source>expected one, since it says what the numbers mean</source>
        <translation>erwartet: einer, da er sagt, was die Zahlen bedeuten</translation>
    </message>
    <message>
        <source>the capture ends within the squeeze</source>
        <translation>die Aufzeichnung endet innerhalb des Druckversuchs</translation>
    </message>
    <message>
        <source>another squeeze began within it</source>
        <translation>ein anderer Druckversuch begann darin</translation>
    </message>
    <message>
        <source>Replay of %1</source>
        <translation>Wiedergabe von %1</translation>
    </message>
    <message>
        <source>it is not open</source>
        <translation>sie ist nicht offen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>loading</source>
        <translation>lädt</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>excitation</source>
        <translation>Anregung</translation>
    </message>
    <message>
        <source>%1, number %2</source>
        <translation>%1, Nummer %2</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>Abtastwert %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>Einzelheit</translation>
    </message>
    <message>
        <source>%1 counts</source>
        <translation>%1 Stufen</translation>
    </message>
    <message>
        <source>forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>watchdog</source>
        <translation>Watchdog</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastwerte</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>scharf</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>bit %1</source>
        <translation>Bit %1</translation>
    </message>
    <message>
        <source>There is nothing to undo now.</source>
        <translation>Jetzt gibt es nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to do again now.</source>
        <translation>Jetzt gibt es nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>taken back</source>
        <translation>zurückgenommen</translation>
    </message>
    <message>
        <source>The recipe has no crush limit. Give the most force and travel that the part bears.</source>
        <translation>Das Rezept hat keine Bruchgrenze. Größte Kraft und größten Weg angeben, die das Teil verträgt.</translation>
    </message>
    <message>
        <source>squeeze %1 of an enrolment</source>
        <translation>Druckversuch %1 eines Einlernens</translation>
    </message>
    <message>
        <source>store the enrolment under way</source>
        <translation>das laufende Einlernen speichern</translation>
    </message>
    <message>
        <source>read the enrolments under way</source>
        <translation>die laufenden Einlernvorgänge lesen</translation>
    </message>
    <message>
        <source>store what belongs together</source>
        <translation>speichern, was zusammengehört</translation>
    </message>
    <message>
        <source>put the squeeze back</source>
        <translation>den Druckversuch wieder aufnehmen</translation>
    </message>
    <message>
        <source>%2 of %1 counts again.</source>
        <translation>%2 von %1: zählt wieder.</translation>
    </message>
    <message>
        <source>An enrolment needs the name of its type.</source>
        <translation>Ein Einlernen braucht den Namen seines Typs.</translation>
    </message>
    <message>
        <source>end the enrolment</source>
        <translation>das Einlernen beenden</translation>
    </message>
    <message>
        <source>A picture of a part is PNG or JPEG.</source>
        <translation>Das Bild eines Teils ist PNG oder JPEG.</translation>
    </message>
    <message>
        <source>store the picture</source>
        <translation>das Bild speichern</translation>
    </message>
    <message>
        <source>store the type&apos;s picture</source>
        <translation>das Bild des Typs speichern</translation>
    </message>
    <message>
        <source>read the picture</source>
        <translation>das Bild lesen</translation>
    </message>
    <message>
        <source>picture %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>The picture %1</source>
        <translation>Das Bild %1</translation>
    </message>
    <message>
        <source>read the type&apos;s picture</source>
        <translation>das Bild des Typs lesen</translation>
    </message>
    <message>
        <source>the gripper failed its check on the reference object (%1). Find out why and check it again, then squeeze again.</source>
        <translation>der Greifer hat die Kontrolle am Referenzobjekt nicht bestanden (%1). Die Ursache suchen und erneut kontrollieren, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the check of the gripper on its reference object was due (%1). Check it, then squeeze again.</source>
        <translation>die Kontrolle des Greifers am Referenzobjekt war fällig (%1). Kontrollieren, dann erneut drücken.</translation>
    </message>
    <message>
        <source>The load that was put on must be a number.</source>
        <translation>Die aufgelegte Last muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>read the history</source>
        <translation>Verlauf lesen</translation>
    </message>
    <message>
        <source>%1 no longer has a code for scanners.</source>
        <translation>%1 hat keinen Scannercode mehr.</translation>
    </message>
    <message>
        <source>%1 got the code %2 for scanners.</source>
        <translation>%1 bekam den Scannercode %2.</translation>
    </message>
    <message>
        <source>button</source>
        <translation>Knopf</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Before entry %1 at least one entry was removed.</source>
        <translation>Vor Eintrag %1 wurde mindestens ein Eintrag entfernt.</translation>
    </message>
    <message>
        <source>Entry %1 does not follow from the one before it: an entry was removed, put in or exchanged.</source>
        <translation>Eintrag %1 folgt nicht aus dem davor: Ein Eintrag wurde entfernt, eingefügt oder vertauscht.</translation>
    </message>
    <message>
        <source>Entry %1 was changed after it was written.</source>
        <translation>Eintrag %1 wurde geändert, nachdem er geschrieben war.</translation>
    </message>
    <message>
        <source>From entry %1 on entries are missing at the end: this computer has seen more of them.</source>
        <translation>Ab Eintrag %1 fehlen Einträge am Ende: Dieser Rechner hat schon mehr davon gesehen.</translation>
    </message>
    <message>
        <source>Entry %1 is not the one that this computer has seen: the trail was written anew, or another library was put in its place.</source>
        <translation>Eintrag %1 ist nicht der, den dieser Rechner gesehen hat: Das Protokoll wurde neu geschrieben, oder eine andere Bibliothek liegt an ihrer Stelle.</translation>
    </message>
    <message>
        <source>The audit trail is not in order. %1 Keep the library as it is, compare it with a copy, and tell whoever answers for quality.</source>
        <translation>Das Änderungsprotokoll ist nicht in Ordnung. %1 Die Bibliothek lassen, wie sie ist, mit einer Kopie vergleichen und die Qualitätsverantwortlichen verständigen.</translation>
    </message>
    <message>
        <source>The audit trail is empty.</source>
        <translation>Das Änderungsprotokoll ist leer.</translation>
    </message>
    <message>
        <source>All %1 entries are as they were written, in order and without a gap.</source>
        <translation>Alle %1 Einträge sind, wie sie geschrieben wurden, in der richtigen Folge und ohne Lücke.</translation>
    </message>
    <message>
        <source>%1 The end agrees with what this computer has seen.</source>
        <translation>%1 Das Ende stimmt mit dem überein, was dieser Rechner gesehen hat.</translation>
    </message>
    <message>
        <source>%1 This computer has not seen this library before: whether entries are missing at the end cannot be told here.</source>
        <translation>%1 Dieser Rechner hat diese Bibliothek noch nicht gesehen: Ob am Ende Einträge fehlen, ist hier nicht zu erkennen.</translation>
    </message>
    <message>
        <source>Signed in</source>
        <translation>Angemeldet</translation>
    </message>
    <message>
        <source>Signed out</source>
        <translation>Abgemeldet</translation>
    </message>
    <message>
        <source>Wrong PIN or password</source>
        <translation>Falsche PIN oder falsches Passwort</translation>
    </message>
    <message>
        <source>Authorised</source>
        <translation>Genehmigt</translation>
    </message>
    <message>
        <source>Person added</source>
        <translation>Person hinzugefügt</translation>
    </message>
    <message>
        <source>Role changed</source>
        <translation>Rolle geändert</translation>
    </message>
    <message>
        <source>PIN or password changed</source>
        <translation>PIN oder Passwort geändert</translation>
    </message>
    <message>
        <source>Person deactivated</source>
        <translation>Person gesperrt</translation>
    </message>
    <message>
        <source>Person reactivated</source>
        <translation>Person entsperrt</translation>
    </message>
    <message>
        <source>Rates changed</source>
        <translation>Fehlerraten geändert</translation>
    </message>
    <message>
        <source>Setting changed</source>
        <translation>Einstellung geändert</translation>
    </message>
    <message>
        <source>Calibration accepted</source>
        <translation>Kalibrierung übernommen</translation>
    </message>
    <message>
        <source>Reference object stated</source>
        <translation>Referenzobjekt angegeben</translation>
    </message>
    <message>
        <source>Checked on the reference object</source>
        <translation>Am Referenzteil geprüft</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>durchgefallen</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>Gripper&apos;s channels measured</source>
        <translation>Kanäle des Greifers vermessen</translation>
    </message>
    <message>
        <source>Type added</source>
        <translation>Typ hinzugefügt</translation>
    </message>
    <message>
        <source>Squeeze enrolled</source>
        <translation>Druckversuch eingelernt</translation>
    </message>
    <message>
        <source>Squeeze dropped</source>
        <translation>Druckversuch verworfen</translation>
    </message>
    <message>
        <source>Squeeze put back</source>
        <translation>Druckversuch zurückgeholt</translation>
    </message>
    <message>
        <source>Recipe changed</source>
        <translation>Rezept geändert</translation>
    </message>
    <message>
        <source>Type approved</source>
        <translation>Typ freigegeben</translation>
    </message>
    <message>
        <source>Type renamed</source>
        <translation>Typ umbenannt</translation>
    </message>
    <message>
        <source>Types merged</source>
        <translation>Typen zusammengeführt</translation>
    </message>
    <message>
        <source>Type split</source>
        <translation>Typ geteilt</translation>
    </message>
    <message>
        <source>Type retired</source>
        <translation>Typ außer Gebrauch genommen</translation>
    </message>
    <message>
        <source>Type put back</source>
        <translation>Typ wieder in Gebrauch genommen</translation>
    </message>
    <message>
        <source>Version restored</source>
        <translation>Stand wiederhergestellt</translation>
    </message>
    <message>
        <source>Example types added</source>
        <translation>Beispieltypen hinzugefügt</translation>
    </message>
    <message>
        <source>Changing the rates of verdicts</source>
        <translation>Fehlerraten ändern</translation>
    </message>
    <message>
        <source>Changing a recipe and its limits</source>
        <translation>Rezept und Grenzen ändern</translation>
    </message>
    <message>
        <source>Approving a type</source>
        <translation>Typ freigeben</translation>
    </message>
    <message>
        <source>Changing enrolled types</source>
        <translation>Eingelernte Typen ändern</translation>
    </message>
    <message>
        <source>Dropping a squeeze</source>
        <translation>Druckversuch verwerfen oder zurückholen</translation>
    </message>
    <message>
        <source>Enrolling squeezes from files</source>
        <translation>Druckversuche aus Dateien einlernen</translation>
    </message>
    <message>
        <source>Accepting a calibration</source>
        <translation>Kalibrierung übernehmen</translation>
    </message>
    <message>
        <source>Managing people</source>
        <translation>Personen verwalten</translation>
    </message>
    <message>
        <source>Changing settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message>
        <source>supervisor</source>
        <translation>Aufsicht</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>Bedienung</translation>
    </message>
    <message>
        <source>That is too long: at most %1 characters.</source>
        <translation>Das ist zu lang: höchstens %1 Zeichen.</translation>
    </message>
    <message>
        <source>That is too short: a PIN has %1 digits or more, a password %2 characters or more.</source>
        <translation>Das ist zu kurz: Eine PIN hat mindestens %1 Ziffern, ein Passwort mindestens %2 Zeichen.</translation>
    </message>
    <message>
        <source>store the PIN or password</source>
        <translation>PIN oder Passwort speichern</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Arbeitsspeicher reicht nicht</translation>
    </message>
    <message>
        <source>read its audit trail</source>
        <translation>das Änderungsprotokoll lesen</translation>
    </message>
    <message>
        <source>continue the audit trail</source>
        <translation>das Änderungsprotokoll fortschreiben</translation>
    </message>
    <message>
        <source>change its people</source>
        <translation>die Personen ändern</translation>
    </message>
    <message>
        <source>such person</source>
        <translation>solche Person</translation>
    </message>
    <message>
        <source>There is already somebody called %1. Add a second name or a number.</source>
        <translation>%1 gibt es schon. Einen zweiten Namen oder eine Nummer dazusetzen.</translation>
    </message>
    <message>
        <source>%1 is the last supervisor. Make somebody else a supervisor first.</source>
        <translation>%1 ist die letzte Aufsicht. Erst jemand anderen zur Aufsicht machen.</translation>
    </message>
    <message>
        <source>There were too many wrong tries for %1. Wait %2, then try again, or ask a supervisor for a new PIN or password.</source>
        <translation>Zu viele falsche Versuche für %1. %2 warten, dann noch einmal versuchen, oder von einer Aufsicht eine neue PIN oder ein neues Passwort geben lassen.</translation>
    </message>
    <message>
        <source>That is not the PIN or password of %1.</source>
        <translation>Das ist nicht die PIN oder das Passwort von %1.</translation>
    </message>
    <message>
        <source>%1 Wait %2 before the next try.</source>
        <translation>%1 Vor dem nächsten Versuch %2 warten.</translation>
    </message>
    <message>
        <source>%1 Tries left before there is a wait: %2.</source>
        <translation>%1 Versuche, bis gewartet werden muss: %2.</translation>
    </message>
    <message>
        <source>person called %1 in the library</source>
        <translation>Person namens %1 in der Bibliothek</translation>
    </message>
    <message>
        <source>The person needs a name.</source>
        <translation>Die Person braucht einen Namen.</translation>
    </message>
    <message>
        <source>The first person must be a supervisor: from then on only a supervisor can add others.</source>
        <translation>Die erste Person muss Aufsicht sein: Danach kann nur eine Aufsicht weitere hinzufügen.</translation>
    </message>
    <message>
        <source>note the try to sign in</source>
        <translation>den Anmeldeversuch festhalten</translation>
    </message>
    <message>
        <source>%1 is not active in this library any more.</source>
        <translation>%1 ist in dieser Bibliothek gesperrt.</translation>
    </message>
    <message>
        <source>%1 is an operator. A supervisor is needed.</source>
        <translation>%1 gehört zur Bedienung. Nötig ist eine Aufsicht.</translation>
    </message>
    <message>
        <source>note that somebody signed out</source>
        <translation>die Abmeldung festhalten</translation>
    </message>
    <message>
        <source>%1 needs a supervisor. Nothing was changed; ask one to authorise it.</source>
        <translation>%1: Das braucht eine Aufsicht. Nichts wurde geändert; eine Aufsicht um Genehmigung bitten.</translation>
    </message>
    <message>
        <source>read its people</source>
        <translation>die Personen lesen</translation>
    </message>
    <message>
        <source>store the person</source>
        <translation>die Person speichern</translation>
    </message>
    <message>
        <source>batch with the key %1</source>
        <translation>Los mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>A batch needs a name or number of at most %1 characters.</source>
        <translation>Ein Los braucht einen Namen oder eine Nummer mit höchstens %1 Zeichen.</translation>
    </message>
    <message>
        <source>A batch has 1 to %1 parts.</source>
        <translation>Ein Los hat 1 bis %1 Teile.</translation>
    </message>
    <message>
        <source>begin the batch</source>
        <translation>Los beginnen</translation>
    </message>
    <message>
        <source>Batch %1 is under way here. End it first.</source>
        <translation>Hier läuft das Los %1. Erst dieses beenden.</translation>
    </message>
    <message>
        <source>end the batch</source>
        <translation>Los beenden</translation>
    </message>
    <message>
        <source>%1 has the code %2 already.</source>
        <translation>%1 hat den Code %2 schon.</translation>
    </message>
    <message>
        <source>store the code</source>
        <translation>Code speichern</translation>
    </message>
    <message>
        <source>There is no baseline that was measured well enough to be used.</source>
        <translation>Es gibt keinen Leerwert, der gut genug gemessen wurde, um ihn zu verwenden.</translation>
    </message>
    <message>
        <source>There is no baseline that could be taken away now.</source>
        <translation>Es gibt jetzt keinen Leerwert, der weggenommen werden könnte.</translation>
    </message>
    <message>
        <source>This gripper has no reference object yet.</source>
        <translation>Dieser Greifer hat noch kein Referenzobjekt.</translation>
    </message>
    <message>
        <source>Squeezes are under way. Wait for their end or stop them.</source>
        <translation>Es laufen Druckversuche. Ihr Ende abwarten oder sie stoppen.</translation>
    </message>
    <message>
        <source>The measurement</source>
        <translation>Die Messung</translation>
    </message>
    <message>
        <source>Another gripper is connected than the one that was measured. Connect gripper %1, then try again.</source>
        <translation>Es ist ein anderer Greifer verbunden als der gemessene. Greifer %1 verbinden, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>read the estimates</source>
        <translation>Schätzungen lesen</translation>
    </message>
    <message>
        <source>add the example types</source>
        <translation>Beispieltypen hinzufügen</translation>
    </message>
    <message>
        <source>An estimate holds a number that is not finite.</source>
        <translation>Eine Schätzung enthält eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>store the reference object</source>
        <translation>Referenzobjekt speichern</translation>
    </message>
    <message>
        <source>A number that was measured in the check is not finite.</source>
        <translation>Eine Zahl, die bei der Kontrolle gemessen wurde, ist nicht endlich.</translation>
    </message>
    <message>
        <source>store the check on the reference object</source>
        <translation>Kontrolle am Referenzobjekt speichern</translation>
    </message>
    <message>
        <source>the reference object of this check</source>
        <translation>Referenzobjekt dieser Kontrolle</translation>
    </message>
    <message>
        <source>found degree %1</source>
        <translation>gefunden: Grad %1</translation>
    </message>
    <message>
        <source>last on %1 at %2</source>
        <translation>zuletzt an %1, %2</translation>
    </message>
    <message>
        <source>never on %1</source>
        <translation>noch nie an %1</translation>
    </message>
    <message>
        <source>The reference object needs a name, such as the number on it.</source>
        <translation>Das Referenzobjekt braucht einen Namen, etwa die Nummer darauf.</translation>
    </message>
    <message>
        <source>The stiffness of the reference object must be known.</source>
        <translation>Die Steifigkeit des Referenzobjekts muss bekannt sein.</translation>
    </message>
    <message>
        <source>What is stated needs a value and a tolerance above zero.</source>
        <translation>Zu jeder Angabe gehören ein Wert und eine Toleranz größer als null.</translation>
    </message>
    <message>
        <source>A tolerance is smaller than twice the uncertainty of what is stated: no measurement could tell. Widen it, or use a better reference object.</source>
        <translation>Eine Toleranz ist kleiner als das Doppelte der angegebenen Unsicherheit: Keine Messung könnte das entscheiden. Die Toleranz weiten oder ein besseres Referenzobjekt verwenden.</translation>
    </message>
    <message>
        <source>The force must stay above zero: let it vary by less than its middle.</source>
        <translation>Die Kraft muss über null bleiben: Sie darf sich nur um weniger als ihre Mitte ändern.</translation>
    </message>
    <message>
        <source>A check may have 1 to %1 squeezes.</source>
        <translation>Eine Kontrolle darf 1 bis %1 Druckversuche haben.</translation>
    </message>
    <message>
        <source>A check may hold for a year at the most.</source>
        <translation>Eine Kontrolle darf höchstens ein Jahr gelten.</translation>
    </message>
    <message>
        <source>at least one object is needed</source>
        <translation>mindestens ein Objekt wird gebraucht</translation>
    </message>
    <message>
        <source>peak and limit must be numbers above 0, the bias a number</source>
        <translation>Spitze und Grenze müssen Zahlen über 0 sein, die Grundkraft eine Zahl</translation>
    </message>
    <message>
        <source>duration, sample time and noise must be numbers above 0</source>
        <translation>Dauer, Abtastzeit und Rauschen müssen Zahlen über 0 sein</translation>
    </message>
    <message>
        <source>the shortest run must be a number from 0 up</source>
        <translation>der kürzeste Lauf muss eine Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>bias and limit leave no room: no force may be above %1 nor below 0</source>
        <translation>Grundkraft und Grenze lassen keinen Raum: Keine Kraft darf über %L1 oder unter 0 liegen</translation>
    </message>
    <message>
        <source>bias and limit leave no room: no force may be above %1</source>
        <translation>Grundkraft und Grenze lassen keinen Raum: Keine Kraft darf über %L1 liegen</translation>
    </message>
    <message>
        <source>the signal must have from %1 to %2 samples</source>
        <translation>das Signal muss %1 bis %2 Abtastwerte haben</translation>
    </message>
    <message>
        <source>m, b and k of object %1 must be numbers above 0</source>
        <translation>m, b und k des Objekts %1 müssen Zahlen über 0 sein</translation>
    </message>
    <message>
        <source>object %1 swings too fast or too slowly for this sample time and duration</source>
        <translation>Objekt %1 schwingt zu schnell oder zu langsam für diese Abtastzeit und Dauer</translation>
    </message>
    <message>
        <source>%1 by %2%3 %</source>
        <translation>%1 um %2%3 %</translation>
    </message>
    <message>
        <source>whether samples are missing cannot be seen: the gripper sends neither a number nor a clock</source>
        <translation>ob Abtastwerte fehlen, ist nicht zu sehen: Der Greifer sendet weder Nummer noch Uhr</translation>
    </message>
    <message>
        <source>found %1</source>
        <translation>gefunden: %1</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>erwartet: %1</translation>
    </message>
    <message>
        <source>%1 fields</source>
        <translation>%1 Felder</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>no m, b and k above zero were found with their uncertainty</source>
        <translation>m, b und k größer als null waren mit ihrer Unsicherheit nicht zu finden</translation>
    </message>
    <message>
        <source>empty gripper, %1 squeezes</source>
        <translation>leerer Greifer, %1 Druckversuche</translation>
    </message>
    <message>
        <source>the empty gripper is no longer taken off</source>
        <translation>der leere Greifer wird nicht mehr abgezogen</translation>
    </message>
    <message>
        <source>calibrate</source>
        <translation>kalibrieren</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>The units of this gripper&apos;s channels (%1, %2) are not known, so that m, b and k cannot be held against what is stated.</source>
        <translation>Die Einheiten der Kanäle dieses Greifers (%1, %2) sind nicht bekannt, sodass sich m, b und k nicht mit den Angaben vergleichen lassen.</translation>
    </message>
    <message>
        <source>squeeze %1: %2</source>
        <translation>Druckversuch %1: %2</translation>
    </message>
    <message>
        <source>found %1: %2</source>
        <translation>gefunden: %1: %2</translation>
    </message>
    <message>
        <source>read the batches</source>
        <translation>Lose lesen</translation>
    </message>
    <message>
        <source>A calibration</source>
        <translation>Eine Kalibrierung</translation>
    </message>
    <message>
        <source>This gripper has no serial number to keep its reference object under.</source>
        <translation>Dieser Greifer hat keine Seriennummer, unter der sein Referenzobjekt aufbewahrt werden könnte.</translation>
    </message>
    <message>
        <source>be brought up to date</source>
        <translation>auf den neuesten Stand bringen</translation>
    </message>
    <message>
        <source>its tables (&quot;%1&quot;) were made by another edition of this program</source>
        <translation>ihre Tabellen („%1“) stammen von einer anderen Ausgabe dieses Programms</translation>
    </message>
    <message>
        <source>types, squeezes and inspections</source>
        <translation>Typen, Druckversuche und Prüfungen</translation>
    </message>
    <message>
        <source>what is known of a gripper&apos;s channels</source>
        <translation>was von den Kanälen eines Greifers bekannt ist</translation>
    </message>
    <message>
        <source>the noise of a gripper&apos;s force channel</source>
        <translation>das Rauschen des Kraftkanals eines Greifers</translation>
    </message>
    <message>
        <source>versions of the library, and parts</source>
        <translation>Versionen der Bibliothek und Teile</translation>
    </message>
    <message>
        <source>calibrations of sensors</source>
        <translation>Kalibrierungen von Sensoren</translation>
    </message>
    <message>
        <source>pictures of parts, and enrolments under way</source>
        <translation>Bilder von Teilen und laufende Einlernvorgänge</translation>
    </message>
    <message>
        <source>checks on a reference object</source>
        <translation>Kontrollen an einem Referenzobjekt</translation>
    </message>
    <message>
        <source>what the history shows of squeezes</source>
        <translation>was der Verlauf von Druckversuchen zeigt</translation>
    </message>
    <message>
        <source>batches, and codes of types</source>
        <translation>Lose und Codes von Typen</translation>
    </message>
    <message>
        <source>people and the audit trail</source>
        <translation>Personen und das Änderungsprotokoll</translation>
    </message>
    <message>
        <source>it is the database of another program</source>
        <translation>sie ist die Datenbank eines anderen Programms</translation>
    </message>
    <message>
        <source>A recording</source>
        <translation>Eine Aufnahme</translation>
    </message>
    <message>
        <source>read the checks on the reference object</source>
        <translation>Kontrollen am Referenzobjekt lesen</translation>
    </message>
    <message>
        <source>A check on the reference object</source>
        <translation>Eine Kontrolle am Referenzobjekt</translation>
    </message>
    <message>
        <source>a verdict is none of the three</source>
        <translation>ein Urteil ist keines der drei</translation>
    </message>
    <message>
        <source>it is on an object that is not there</source>
        <translation>sie gilt einem Objekt, das nicht da ist</translation>
    </message>
    <message>
        <source>read the reference objects</source>
        <translation>Referenzobjekte lesen</translation>
    </message>
    <message>
        <source>Start this program with sudo, or let your user write to it until the next start of the computer: sudo setfacl -m u:$USER:rw /dev/uhid</source>
        <translation>Dieses Programm mit sudo starten, oder dem Benutzer das Schreiben bis zum nächsten Start des Rechners erlauben: sudo setfacl -m u:$USER:rw /dev/uhid</translation>
    </message>
    <message>
        <source>Load the kernel&apos;s module first: sudo modprobe uhid. (Containers and some virtual machines do not have it; virtual: works everywhere.)</source>
        <translation>Erst das Kernelmodul laden: sudo modprobe uhid. (Container und manche virtuelle Maschinen haben es nicht; virtual: geht überall.)</translation>
    </message>
    <message>
        <source>the system closed it</source>
        <translation>das System hat es geschlossen</translation>
    </message>
    <message>
        <source>report ID</source>
        <translation>Report-ID</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>eine Liste mit %1 Einträgen</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>no &quot;%1&quot;</source>
        <translation>kein „%1“</translation>
    </message>
    <message>
        <source>the unknown name &quot;%1&quot;</source>
        <translation>der unbekannte Name „%1“</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>cut short: %1 bytes are missing</source>
        <translation>abgeschnitten: %1 Bytes fehlen</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>ein Anteil von 0 bis 1</translation>
    </message>
    <message>
        <source>newtons from 0 to 1000000, or off</source>
        <translation>Newton von 0 bis 1000000, oder off</translation>
    </message>
    <message>
        <source>seconds from -1000 to 1000</source>
        <translation>Sekunden von -1000 bis 1000</translation>
    </message>
    <message>
        <source>nothing, seconds from 0 to 60, or off</source>
        <translation>nichts, Sekunden von 0 bis 60, oder off</translation>
    </message>
    <message>
        <source>nothing, or off</source>
        <translation>nichts, oder off</translation>
    </message>
    <message>
        <source>nothing, off, or one of %1</source>
        <translation>nichts, off, oder eines von %1</translation>
    </message>
    <message>
        <source>the line ends</source>
        <translation>die Zeile endet</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;</source>
        <translation>gefunden: „%1“</translation>
    </message>
    <message>
        <source>a time in seconds, from 0 to 1000000</source>
        <translation>eine Zeit in Sekunden, von 0 bis 1000000</translation>
    </message>
    <message>
        <source>a time not before that of the line above, %1 s</source>
        <translation>eine Zeit nicht vor der in der Zeile darüber, %L1 s</translation>
    </message>
    <message>
        <source>%1 behind %2</source>
        <translation>%1 nach %2</translation>
    </message>
    <message>
        <source>the end of the line; a comment begins with #</source>
        <translation>das Ende der Zeile; ein Kommentar beginnt mit #</translation>
    </message>
    <message>
        <source>the largest force is above its own limit</source>
        <translation>die größte Kraft liegt über seiner eigenen Grenze</translation>
    </message>
    <message>
        <source>the largest force is not above zero</source>
        <translation>die größte Kraft liegt nicht über null</translation>
    </message>
    <message>
        <source>the longest travel is above its own limit</source>
        <translation>der größte Weg liegt über seiner eigenen Grenze</translation>
    </message>
    <message>
        <source>the longest travel is not above zero</source>
        <translation>der größte Weg liegt nicht über null</translation>
    </message>
    <message>
        <source>force %1 of the signal is above the limit</source>
        <translation>Kraft %1 des Signals liegt über der Grenze</translation>
    </message>
    <message>
        <source>force %1 of the signal is outside its range</source>
        <translation>Kraft %1 des Signals liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>force %1 of the signal is missing</source>
        <translation>Kraft %1 des Signals fehlt</translation>
    </message>
    <message>
        <source>squeeze %1 was started already; this one is not behind it</source>
        <translation>Druckversuch %1 wurde schon gestartet; dieser liegt nicht dahinter</translation>
    </message>
    <message>
        <source>it reports a fault: its code %1</source>
        <translation>er meldet einen Fehler: seine Nummer %1</translation>
    </message>
    <message>
        <source>the report has %1 bytes, not 64 bytes</source>
        <translation>der Report hat %1 Bytes, nicht 64</translation>
    </message>
    <message>
        <source>it speaks version %1 of the protocol, this program %2</source>
        <translation>er spricht Version %1 des Protokolls, dieses Programm %2</translation>
    </message>
    <message>
        <source>excitation state</source>
        <translation>Zustand der Anregung</translation>
    </message>
    <message>
        <source>number of samples</source>
        <translation>Zahl der Abtastwerte</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>number of forces</source>
        <translation>Zahl der Kräfte</translation>
    </message>
    <message>
        <source>force unit</source>
        <translation>Einheit der Kraft</translation>
    </message>
    <message>
        <source>position unit</source>
        <translation>Einheit des Wegs</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2; it must be %3</source>
        <translation>Feld „%1“: %2; erlaubt ist %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2; it must be from %3 to %4</source>
        <translation>Feld „%1“: %2; erlaubt ist %3 bis %4</translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>sie ist größer als %1 MB</translation>
    </message>
    <message>
        <source>it is a pipe or a device and not a file</source>
        <translation>das ist eine Pipe oder ein Gerät und keine Datei</translation>
    </message>
    <message>
        <source>the force stands at the end of its sensor&apos;s range in %1 of %2 samples.</source>
        <translation>die Kraft steht in %1 von %2 Abtastwerten am Ende des Bereichs ihres Sensors.</translation>
    </message>
    <message>
        <source>the position stands at the end of its sensor&apos;s range in %1 of %2 samples.</source>
        <translation>der Weg steht in %1 von %2 Abtastwerten am Ende des Bereichs seines Sensors.</translation>
    </message>
    <message>
        <source>The gripper itself did not notice.</source>
        <translation>Der Greifer selbst hat es nicht bemerkt.</translation>
    </message>
    <message>
        <source>Squeeze with less force, and check where the sensor&apos;s range ends.</source>
        <translation>Mit weniger Kraft drücken und prüfen, wo der Bereich des Sensors endet.</translation>
    </message>
    <message>
        <source>no sample stands at the end of a sensor&apos;s range</source>
        <translation>kein Abtastwert steht am Ende des Bereichs eines Sensors</translation>
    </message>
    <message>
        <source>no channel stood still while the other moved</source>
        <translation>kein Kanal stand still, während der andere sich bewegte</translation>
    </message>
    <message>
        <source>the position channel is stuck: it stands at %1 in %2 of %3 samples while the force moves. Check the position sensor and its cable, then squeeze again.</source>
        <translation>der Wegkanal steckt fest: Er steht in %2 von %3 Abtastwerten auf %1, während die Kraft sich bewegt. Wegsensor und Kabel prüfen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the force channel is stuck: it stands at %1 in %2 of %3 samples while the position moves. Check the force sensor and its cable, then squeeze again.</source>
        <translation>der Kraftkanal steckt fest: Er steht in %2 von %3 Abtastwerten auf %1, während der Weg sich bewegt. Kraftsensor und Kabel prüfen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the gripper reported no fault of its own</source>
        <translation>der Greifer meldete keinen eigenen Fehler</translation>
    </message>
    <message>
        <source>the gripper reported a fault of its own in %1 of %2 samples, so what it measured cannot be relied on. Find out what is wrong with it, then squeeze again.</source>
        <translation>der Greifer meldete in %1 von %2 Abtastwerten einen eigenen Fehler; auf das Gemessene ist kein Verlass. Herausfinden, was ihm fehlt, dann erneut drücken.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ppm</source>
        <translation>%1 ppm</translation>
    </message>
    <message>
        <source>the sample time that the gripper states, %1 ms, does not hold: its time stamps come every %2 ms, and m, b and k are wrong. Correct the stated sample time, then squeeze again.</source>
        <translation>die Abtastzeit, die der Greifer angibt, %1 ms, stimmt nicht: Seine Zeitstempel kommen alle %2 ms, und m, b und k sind falsch. Die angegebene Abtastzeit berichtigen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the sample time that the gripper states, %1 ms, does not hold: its clock contradicts its sample count %2 times, and m, b and k are wrong. Correct the stated sample time, then squeeze again.</source>
        <translation>die Abtastzeit, die der Greifer angibt, %1 ms, stimmt nicht: Seine Uhr widerspricht seiner Zählung der Abtastwerte %2-mal, und m, b und k sind falsch. Die angegebene Abtastzeit berichtigen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the sample time that the gripper states, %1 ms, does not hold: by the computer&apos;s clock its samples come %2 too often, and m is off by about %3 %. Correct the stated sample time, then squeeze again.</source>
        <translation>die Abtastzeit, die der Greifer angibt, %1 ms, stimmt nicht: Nach der Uhr des Rechners kommen seine Abtastwerte um %2 zu oft, und m ist um etwa %3 % falsch. Die angegebene Abtastzeit berichtigen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the sample time that the gripper states, %1 ms, does not hold: by the computer&apos;s clock its samples come %2 too seldom, and m is off by about %3 %. Correct the stated sample time, then squeeze again.</source>
        <translation>die Abtastzeit, die der Greifer angibt, %1 ms, stimmt nicht: Nach der Uhr des Rechners kommen seine Abtastwerte um %2 zu selten, und m ist um etwa %3 % falsch. Die angegebene Abtastzeit berichtigen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>not judged yet: the connection is too young to hold the gripper&apos;s clock against the computer&apos;s</source>
        <translation>noch nicht beurteilt: Die Verbindung ist zu jung, um die Uhr des Greifers mit der des Rechners zu vergleichen</translation>
    </message>
    <message>
        <source>not judged: the recording does not tell how the gripper&apos;s clock ran beside a computer&apos;s</source>
        <translation>nicht beurteilt: Die Aufnahme sagt nicht, wie die Uhr des Greifers neben der eines Rechners ging</translation>
    </message>
    <message>
        <source>the gripper&apos;s clock and the computer&apos;s differ by %1 ± %2 ppm</source>
        <translation>die Uhren des Greifers und des Rechners unterscheiden sich um %1 ± %2 ppm</translation>
    </message>
    <message>
        <source>the gripper&apos;s clock is %1 fast beside the computer&apos;s: m is off by about %2 %. Have its clock mended, then squeeze again.</source>
        <translation>die Uhr des Greifers geht um %1 schneller als die des Rechners: m ist um etwa %2 % falsch. Seine Uhr instand setzen lassen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the gripper&apos;s clock is %1 slow beside the computer&apos;s: m is off by about %2 %. Have its clock mended, then squeeze again.</source>
        <translation>die Uhr des Greifers geht um %1 langsamer als die des Rechners: m ist um etwa %2 % falsch. Seine Uhr instand setzen lassen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the samples come as often as the gripper&apos;s own clock says, which is off</source>
        <translation>die Abtastwerte kommen so oft, wie die Uhr des Greifers sagt, und die geht falsch</translation>
    </message>
    <message>
        <source>the samples come as often as the gripper states</source>
        <translation>die Abtastwerte kommen so oft, wie der Greifer angibt</translation>
    </message>
    <message>
        <source>the samples come as often as the time stamps say</source>
        <translation>die Abtastwerte kommen so oft, wie die Zeitstempel sagen</translation>
    </message>
    <message>
        <source>the estimator found no answer</source>
        <translation>der Schätzer fand kein Ergebnis</translation>
    </message>
    <message>
        <source>the estimator found no answer: %1</source>
        <translation>der Schätzer fand kein Ergebnis: %1</translation>
    </message>
    <message>
        <source>Who may arm changed</source>
        <translation>Wer scharf schalten darf, geändert</translation>
    </message>
    <message>
        <source>Gripper armed</source>
        <translation>Greifer scharf geschaltet</translation>
    </message>
    <message>
        <source>Arming the gripper</source>
        <translation>Scharfschalten des Greifers</translation>
    </message>
    <message>
        <source>Suspect measurement: %1</source>
        <translation>Fragliche Messung: %1</translation>
    </message>
    <message>
        <source>its sample time is %1 s and not %2</source>
        <translation>seine Abtastzeit ist %1 s und nicht %2</translation>
    </message>
    <message>
        <source>its force lag is %1 s, at most %2 s can be</source>
        <translation>sein Kraftversatz ist %1 s, höchstens %2 s sind möglich</translation>
    </message>
    <message>
        <source>%1 was measured, above the limit of %2</source>
        <translation>%1 wurden gemessen, mehr als die Grenze von %2</translation>
    </message>
    <message>
        <source>%1 of its reports since then could not be read, and no other told of a movement</source>
        <translation>%1 seiner Reports seither waren nicht lesbar, und kein anderer meldete eine Bewegung</translation>
    </message>
    <message>
        <source>what a recording can hold</source>
        <translation>was eine Aufnahme fasst</translation>
    </message>
    <message>
        <source>the sample time must be %1</source>
        <translation>die Abtastzeit muss %1 sein</translation>
    </message>
    <message>
        <source>found a line of %1 bytes: %2</source>
        <translation>gefunden: eine Zeile von %1 Bytes: %2</translation>
    </message>
    <message>
        <source>expected at most %1 bytes a line</source>
        <translation>erwartet: höchstens %1 Bytes je Zeile</translation>
    </message>
    <message>
        <source>expected seconds from -%1 to %1</source>
        <translation>erwartet: Sekunden von -%1 bis %1</translation>
    </message>
    <message>
        <source>found more than %1 facts</source>
        <translation>gefunden: mehr als %1 Angaben</translation>
    </message>
    <message>
        <source>expected the rows</source>
        <translation>erwartet: die Zeilen</translation>
    </message>
    <message>
        <source>expected a number from %1 to %2</source>
        <translation>erwartet: eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>found more than %1 samples</source>
        <translation>gefunden: mehr als %1 Abtastwerte</translation>
    </message>
    <message>
        <source>expected fewer: cut the recording into parts</source>
        <translation>erwartet: weniger; die Aufnahme in Teile schneiden</translation>
    </message>
    <message>
        <source>The recording can&apos;t be kept: %1.</source>
        <translation>Die Aufnahme lässt sich nicht aufbewahren: %1.</translation>
    </message>
    <message>
        <source>seconds from %1 to %2</source>
        <translation>Sekunden von %1 bis %2</translation>
    </message>
    <message>
        <source>its channels differ in length</source>
        <translation>ihre Kanäle sind verschieden lang</translation>
    </message>
    <message>
        <source>it has %1 samples, at most %2 can be kept</source>
        <translation>sie hat %1 Abtastwerte, höchstens %2 lassen sich aufbewahren</translation>
    </message>
    <message>
        <source>more than %1 facts stand beside its samples</source>
        <translation>neben ihren Abtastwerten stehen mehr als %1 Angaben</translation>
    </message>
    <message>
        <source>one of its numbers is not finite, or beyond %1</source>
        <translation>eine ihrer Zahlen ist nicht endlich oder jenseits von %1</translation>
    </message>
    <message>
        <source>its times do not increase</source>
        <translation>ihre Zeiten steigen nicht an</translation>
    </message>
    <message>
        <source>a number of its measuring chain is not finite, or beyond %1</source>
        <translation>eine Zahl ihrer Messkette ist nicht endlich oder jenseits von %1</translation>
    </message>
    <message>
        <source>it runs a program of its own, the %1 %2, which no library does</source>
        <translation>sie führt ein eigenes Programm aus, %1 %2, was keine Bibliothek tut</translation>
    </message>
    <message>
        <source>policies</source>
        <translation>Richtlinien</translation>
    </message>
    <message>
        <source>it says that it has %1 bytes, at most %2 can be</source>
        <translation>sie gibt %1 Bytes an, höchstens %2 sind möglich</translation>
    </message>
    <message>
        <source>%1 needs somebody who has signed in. Sign in, then try again.</source>
        <translation>%1: Dafür muss jemand angemeldet sein. Anmelden, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>read its policies</source>
        <translation>ihre Richtlinien lesen</translation>
    </message>
    <message>
        <source>store the policy</source>
        <translation>die Richtlinie speichern</translation>
    </message>
    <message>
        <source>good samples do not come, or come too seldom</source>
        <translation>gute Abtastwerte kommen nicht oder zu selten</translation>
    </message>
    <message>
        <source>its reports come every %1 ms; a gripper that is to be stopped in time sends one every %2 ms at least. It can be listened to</source>
        <translation>seine Reports kommen alle %1 ms; ein Greifer, der rechtzeitig anhalten soll, sendet mindestens alle %2 ms einen. Seine Messwerte werden trotzdem gezeigt</translation>
    </message>
    <message>
        <source>it answered too late, and is disarmed again</source>
        <translation>er hat zu spät geantwortet und ist wieder entschärft</translation>
    </message>
    <message>
        <source>left without heartbeats it disarmed itself, but not with its watchdog bit</source>
        <translation>ohne Lebenszeichen entschärfte er sich, aber nicht mit seinem Watchdog-Bit</translation>
    </message>
    <message>
        <source>its watchdog trips after %1 ms already; it states %2 ms</source>
        <translation>sein Watchdog löst schon nach %1 ms aus; angegeben sind %2 ms</translation>
    </message>
    <message>
        <source>left without heartbeats for %1 ms it stayed armed: its watchdog of %2 ms does not work, and nothing would stop it if this program or the cable failed</source>
        <translation>ohne Lebenszeichen blieb er %1 ms lang scharf: Sein Watchdog von %2 ms wirkt nicht, und nichts hielte ihn an, wenn dieses Programm oder das Kabel versagt</translation>
    </message>
    <message>
        <source>another program sends it commands. Close that program first</source>
        <translation>ein anderes Programm sendet ihm Befehle. Erst das andere Programm schließen</translation>
    </message>
    <message>
        <source>it is armed, though this program did not arm it</source>
        <translation>er ist scharf, obwohl dieses Programm ihn nicht scharf geschaltet hat</translation>
    </message>
    <message>
        <source>another program sends it commands. Close that program, then arm again</source>
        <translation>ein anderes Programm sendet ihm Befehle. Das andere Programm schließen, dann wieder scharf schalten</translation>
    </message>
    <message>
        <source>its reports arrive damaged (length, version or checksum wrong), so that nobody would see what it does</source>
        <translation>seine Reports kommen beschädigt an (Länge, Version oder Prüfsumme falsch), sodass niemand sähe, was er tut</translation>
    </message>
    <message>
        <source>no samples came for %1 ms, so that nobody would see what it does</source>
        <translation>%1 ms lang kamen keine Abtastwerte, sodass niemand sähe, was er tut</translation>
    </message>
    <message>
        <source>the program&apos;s window stood still, so that nobody could have pressed Stop</source>
        <translation>das Fenster des Programms stand still, sodass niemand STOPP hätte drücken können</translation>
    </message>
    <message>
        <source>it disarmed itself, without a reason</source>
        <translation>er hat sich ohne Angabe eines Grundes entschärft</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>antworten</translation>
    </message>
    <message>
        <source>a fault is loss:P, duplicate:P, crc:P, saturate:N, stall:S, unplug:S, replug:S, deaf:S, hang-feature:S, hang-write:S, broken:S, button:S, clock-rate:R, stuck or units</source>
        <translation>ein Fehler ist loss:P, duplicate:P, crc:P, saturate:N, stall:S, unplug:S, replug:S, deaf:S, hang-feature:S, hang-write:S, broken:S, button:S, clock-rate:R, stuck oder units</translation>
    </message>
    <message>
        <source>another program uses it. Close that program or disconnect the gripper there, then connect again</source>
        <translation>ein anderes Programm benutzt ihn. Das andere Programm schließen oder den Greifer dort trennen, dann neu verbinden</translation>
    </message>
    <message>
        <source>a sample time of %1</source>
        <translation>eine Abtastzeit von %1</translation>
    </message>
    <message>
        <source>a number of at most %1</source>
        <translation>eine Zahl von höchstens %1</translation>
    </message>
    <message>
        <source>token</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>a record %1 s after the first</source>
        <translation>ein Eintrag %1 s nach dem ersten</translation>
    </message>
    <message>
        <source>expected a session of less than a year</source>
        <translation>erwartet: eine Sitzung von weniger als einem Jahr</translation>
    </message>
    <message>
        <source>found more than %1 squeezes</source>
        <translation>gefunden: mehr als %1 Druckversuche</translation>
    </message>
    <message>
        <source>expected fewer in one session</source>
        <translation>erwartet: weniger in einer Sitzung</translation>
    </message>
    <message>
        <source>expected a gripper that can be</source>
        <translation>erwartet: ein Greifer, den es geben kann</translation>
    </message>
    <message>
        <source>a share from -0.5 to 0.5</source>
        <translation>ein Anteil von -0.5 bis 0.5</translation>
    </message>
    <message>
        <source>ARX(2,1,1)</source>
        <translation>ARX(2,1,1)</translation>
    </message>
    <message>
        <source>ARX, mean force</source>
        <translation>ARX, mittlere Kraft</translation>
    </message>
    <message>
        <source>ARX(2,2,1)</source>
        <translation>ARX(2,2,1)</translation>
    </message>
    <message>
        <source>instrumental var.</source>
        <translation>Hilfsvariablen</translation>
    </message>
    <message>
        <source>output error</source>
        <translation>Ausgangsfehler</translation>
    </message>
    <message>
        <source>cubic spring</source>
        <translation>kubische Feder</translation>
    </message>
    <message>
        <source>periodic</source>
        <translation>periodisch</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Wahrsch.</translation>
    </message>
    <message>
        <source>Mass m</source>
        <translation>Masse m</translation>
    </message>
    <message>
        <source>Damping b</source>
        <translation>Dämpfung b</translation>
    </message>
    <message>
        <source>Stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>Simulation fit</source>
        <translation>Simulationsfit</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>read its ledger</source>
        <translation>ihr Journal lesen</translation>
    </message>
    <message>
        <source>continue its ledger</source>
        <translation>ihr Journal fortschreiben</translation>
    </message>
    <message>
        <source>a row of %1 is not there although it was just stored</source>
        <translation>eine Zeile von %1 fehlt, obwohl sie eben gespeichert wurde</translation>
    </message>
    <message>
        <source>it is not as this program makes it: the %1 %2 %3. Go on with a backup, or ask who changed it</source>
        <translation>sie ist nicht so, wie dieses Programm sie anlegt: %1 %2 %3. Mit einer Sicherung weiterarbeiten oder klären, wer sie verändert hat</translation>
    </message>
    <message>
        <source>the ledger of all rows, and their order</source>
        <translation>das Journal über alle Zeilen und ihre Reihenfolge</translation>
    </message>
    <message>
        <source>be compared with what this program makes</source>
        <translation>mit dem vergleichen, was dieses Programm anlegt</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>differs from what this program makes</source>
        <translation>weicht von dem ab, was dieses Programm anlegt</translation>
    </message>
    <message>
        <source>was made by no version of this program</source>
        <translation>stammt von keiner Version dieses Programms</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>there is no room for the copy that it has to be read from</source>
        <translation>für die Kopie, aus der gelesen werden muss, ist kein Platz</translation>
    </message>
    <message>
        <source>its file %1 was removed or replaced while it was open. Put it back where it was; where that cannot be, close the program, put back a copy and start again</source>
        <translation>ihre Datei %1 wurde entfernt oder ersetzt, während sie geöffnet war. Die Datei an ihren Ort zurücklegen; wo das nicht geht, das Programm schließen, eine Kopie zurückspielen und neu starten</translation>
    </message>
    <message>
        <source>the links before it are missing, from number %1 on</source>
        <translation>die Glieder davor fehlen, ab Nummer %1</translation>
    </message>
    <message>
        <source>does not follow from the link before it</source>
        <translation>folgt nicht aus dem Glied davor</translation>
    </message>
    <message>
        <source>is in a format that this program does not know</source>
        <translation>hat ein Format, das dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>was changed: its hash is of something else</source>
        <translation>wurde geändert: Sein Hash gehört zu etwas anderem</translation>
    </message>
    <message>
        <source>is not signed by the key that its chain belongs to</source>
        <translation>ist nicht mit dem Schlüssel signiert, zu dem seine Kette gehört</translation>
    </message>
    <message>
        <source>its signature is not of it</source>
        <translation>die Signatur gehört nicht dazu</translation>
    </message>
    <message>
        <source>the second place knows another link of this number: the ledger was made anew, or an older copy was put back and gone on with</source>
        <translation>die zweite Stelle kennt ein anderes Glied mit dieser Nummer: Das Journal wurde neu gemacht, oder eine ältere Kopie wurde zurückgespielt und fortgeführt</translation>
    </message>
    <message>
        <source>is missing, and what came after it: the second place knows %1 links. An older copy was put back, or the end was cut off</source>
        <translation>fehlt, und was danach kam: Die zweite Stelle kennt %1 Glieder. Eine ältere Kopie wurde zurückgespielt, oder das Ende wurde abgeschnitten</translation>
    </message>
    <message>
        <source>its leaves cannot be read</source>
        <translation>die Fingerabdrücke darin sind nicht lesbar</translation>
    </message>
    <message>
        <source>be verified</source>
        <translation>nachprüfen</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>points to a row of %1 that is not there</source>
        <translation>verweist auf eine Zeile von %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>is no step of this program</source>
        <translation>ist kein Schritt dieses Programms</translation>
    </message>
    <message>
        <source>it is of version %1 of the library, and what is verified is of version %2. Open it with the program once, which brings it up to date; keep a copy of it as it is</source>
        <translation>sie hat Version %1, nachgeprüft wird Version %2. Einmal mit dem Programm öffnen, das sie auf den neuen Stand bringt; eine Kopie so aufbewahren, wie sie ist</translation>
    </message>
    <message>
        <source>Differences from what was written: %1.</source>
        <translation>Abweichungen von dem, was geschrieben wurde: %1.</translation>
    </message>
    <message>
        <source>The first: %1.</source>
        <translation>Die erste: %1.</translation>
    </message>
    <message>
        <source>Keep a copy of the file, find out who could write it, and go on with a backup that is whole.</source>
        <translation>Eine Kopie der Datei aufbewahren, klären, wer sie schreiben konnte, und mit einer heilen Sicherung weiterarbeiten.</translation>
    </message>
    <message>
        <source>All %1 rows are as they were written.</source>
        <translation>Alle %1 Zeilen sind so, wie sie geschrieben wurden.</translation>
    </message>
    <message>
        <source>Of these, %1 are from before the ledger: they are as they were found when it began.</source>
        <translation>Davon stammen %1 aus der Zeit vor dem Journal: Sie sind so, wie sie bei seinem Beginn vorgefunden wurden.</translation>
    </message>
    <message>
        <source>The second place on this computer knows the same end.</source>
        <translation>Die zweite Stelle auf diesem Rechner kennt dasselbe Ende.</translation>
    </message>
    <message>
        <source>The second place on this computer knows the beginning; what came after was not witnessed by it.</source>
        <translation>Die zweite Stelle auf diesem Rechner kennt den Anfang; was danach kam, hat sie nicht bezeugt.</translation>
    </message>
    <message>
        <source>No second place on this computer knows this library: whether its end is missing cannot be told. Verify it where it is written.</source>
        <translation>Keine zweite Stelle auf diesem Rechner kennt diese Bibliothek: Ob das Ende fehlt, lässt sich nicht sagen. Dort nachprüfen, wo sie geschrieben wird.</translation>
    </message>
    <message>
        <source>is of a table that this program does not know</source>
        <translation>gehört zu einer Tabelle, die dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>was changed</source>
        <translation>wurde geändert</translation>
    </message>
    <message>
        <source>is in the ledger twice</source>
        <translation>steht zweimal im Journal</translation>
    </message>
    <message>
        <source>was put in past this program: the ledger does not know it</source>
        <translation>wurde an diesem Programm vorbei eingefügt: Das Journal kennt sie nicht</translation>
    </message>
    <message>
        <source>Clock was set back</source>
        <translation>Uhr wurde zurückgestellt</translation>
    </message>
    <message>
        <source>%1 inspections are not stored yet, and no more can be kept. %2</source>
        <translation>%1 Prüfungen sind noch nicht gespeichert, und mehr lassen sich nicht behalten. %2</translation>
    </message>
    <message>
        <source>The document of the squeeze %1</source>
        <translation>Das Dokument des Druckversuchs %1</translation>
    </message>
    <message>
        <source>be worked out again</source>
        <translation>neu ausrechnen</translation>
    </message>
    <message>
        <source>its m, b and k cannot be found in its recording</source>
        <translation>m, b und k lassen sich in der Aufnahme nicht finden</translation>
    </message>
    <message>
        <source>its m, b and k are not those of its recording</source>
        <translation>m, b und k sind nicht die der Aufnahme</translation>
    </message>
    <message>
        <source>it has no table %1</source>
        <translation>sie hat keine Tabelle %1</translation>
    </message>
    <message>
        <source>Validity</source>
        <translation>Gültigkeit</translation>
    </message>
    <message>
        <source>Library version</source>
        <translation>Bibliotheksversion</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Storniert</translation>
    </message>
    <message>
        <source>void the inspection</source>
        <translation>Prüfung stornieren</translation>
    </message>
    <message>
        <source>inspection %1</source>
        <translation>Prüfung %1</translation>
    </message>
    <message>
        <source>what was in force when a part was judged</source>
        <translation>was galt, als ein Teil beurteilt wurde</translation>
    </message>
    <message>
        <source>what is not approved is not judged</source>
        <translation>was nicht freigegeben ist, wird nicht beurteilt</translation>
    </message>
    <message>
        <source>inspections that do not count, and part numbers</source>
        <translation>Prüfungen, die nicht zählen, und Teilenummern</translation>
    </message>
    <message>
        <source>tallies of inspections, and recordings stored once</source>
        <translation>Zählstände der Prüfungen und nur einmal gespeicherte Aufnahmen</translation>
    </message>
    <message>
        <source>%1 Its approval is void.</source>
        <translation>%1 Die Freigabe ist damit erloschen.</translation>
    </message>
    <message>
        <source>Inspections that waited to be stored cannot be read (%1). Their file is kept as %2.</source>
        <translation>Prüfungen, die noch zu speichern waren, lassen sich nicht lesen (%1). Ihre Datei ist als %2 aufbewahrt.</translation>
    </message>
    <message>
        <source>the library is another than the one they were made for</source>
        <translation>die Bibliothek ist eine andere als die, für die sie gemacht wurden</translation>
    </message>
    <message>
        <source>bytes of their file are damaged</source>
        <translation>Bytes ihrer Datei sind beschädigt</translation>
    </message>
    <message>
        <source>The file for what is not stored yet</source>
        <translation>Die Datei für noch nicht Gespeichertes</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>sie ist nicht da</translation>
    </message>
    <message>
        <source>other programs have it</source>
        <translation>andere Programme benutzen sie</translation>
    </message>
    <message>
        <source>it is full</source>
        <translation>sie ist voll</translation>
    </message>
    <message>
        <source>An inspection that waited to be stored</source>
        <translation>Eine Prüfung, die noch zu speichern war</translation>
    </message>
    <message>
        <source>%1 was enrolled by the one who approves it, and this library asks for a second person. Nothing was changed; ask another supervisor to approve it.</source>
        <translation>%1 wurde von der Person eingelernt, die den Typ freigeben will, und diese Bibliothek verlangt eine zweite. Nichts wurde geändert; eine andere Aufsicht um die Freigabe bitten.</translation>
    </message>
    <message>
        <source>count the inspections</source>
        <translation>Prüfungen zählen</translation>
    </message>
    <message>
        <source>is not what counting the inspections up to this number finds</source>
        <translation>stimmt nicht mit der Zählung der Prüfungen bis zu dieser Nummer überein</translation>
    </message>
    <message>
        <source>address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>batch</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>confidence</source>
        <translation>Vertrauensniveau</translation>
    </message>
    <message>
        <source>degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>holds until</source>
        <translation>gilt bis</translation>
    </message>
    <message>
        <source>ends when decided</source>
        <translation>endet, wenn entschieden</translation>
    </message>
    <message>
        <source>false reject</source>
        <translation>Fehlrückweisung</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>lag of the force in s</source>
        <translation>Zeitversatz der Kraft in s</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>after nothing was done</source>
        <translation>nach Untätigkeit</translation>
    </message>
    <message>
        <source>other type</source>
        <translation>anderer Typ</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>robust</source>
        <translation>robust</translation>
    </message>
    <message>
        <source>role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>squeezes</source>
        <translation>Druckversuche</translation>
    </message>
    <message>
        <source>stranger accept</source>
        <translation>Fremdannahme</translation>
    </message>
    <message>
        <source>to</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>wrong type</source>
        <translation>Verwechslung</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>Befehlszeile</translation>
    </message>
    <message>
        <source>everybody who has signed in</source>
        <translation>alle, die angemeldet sind</translation>
    </message>
    <message>
        <source>supervisors</source>
        <translation>Aufsicht</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>%1 before, %2 now</source>
        <translation>vorher %1, jetzt %2</translation>
    </message>
    <message>
        <source>Who may approve changed</source>
        <translation>Wer freigeben darf, geändert</translation>
    </message>
    <message>
        <source>Inspection voided</source>
        <translation>Prüfung storniert</translation>
    </message>
    <message>
        <source>Batch begun</source>
        <translation>Los begonnen</translation>
    </message>
    <message>
        <source>Batch ended</source>
        <translation>Los beendet</translation>
    </message>
    <message>
        <source>Exported</source>
        <translation>Exportiert</translation>
    </message>
    <message>
        <source>Kept sessions removed</source>
        <translation>Aufzeichnungen gelöscht</translation>
    </message>
    <message>
        <source>Profile of a gripper installed</source>
        <translation>Profil eines Greifers installiert</translation>
    </message>
    <message>
        <source>A squeeze further than %1 sd from %2 is called unknown, as %3 % of its own are; with all known that would be %4 sd.</source>
        <translation>Ein Druckversuch, der mehr als %L1 σ von %2 entfernt ist, heißt unbekannt, wie %3 % der eigenen; wäre alles bekannt, wären es %L4 σ.</translation>
    </message>
    <message>
        <source>A part as near as 6 sd passes this gate %1 times (at best %2).</source>
        <translation>Ein nur 6 σ entferntes Teil passiert diese Grenze in %1 Fällen (bestenfalls in %2).</translation>
    </message>
    <message>
        <source>Of strangers of any kind, at most %1 % are named a type all the same.</source>
        <translation>Von Fremdteilen aller Art werden höchstens %1 % dennoch als ein Typ benannt.</translation>
    </message>
    <message>
        <source>Enough for verdicts; it takes more than 100 more squeezes to come near the best.</source>
        <translation>Genug für Urteile; bis nahe an das Bestmögliche fehlen mehr als 100 weitere Druckversuche.</translation>
    </message>
    <message>
        <source>Enough for verdicts; %1 would bring them near the best.</source>
        <translation>Genug für Urteile; %1, dann sind sie nahe am Bestmöglichen.</translation>
    </message>
    <message>
        <source>Enough for verdicts: more squeezes would gain little.</source>
        <translation>Genug für Urteile: Weitere Druckversuche brächten wenig.</translation>
    </message>
    <message>
        <source>No type is enrolled and approved yet.</source>
        <translation>Noch ist kein Typ eingelernt und freigegeben.</translation>
    </message>
    <message>
        <source>There is no safe place for an inspection that cannot be stored at once, so nothing is squeezed. %1</source>
        <translation>Für eine Prüfung, die sich nicht sofort speichern lässt, gibt es keinen sicheren Platz; daher wird nichts gedrückt. %1</translation>
    </message>
    <message>
        <source>An inspection that waited to be stored was refused, and is kept in %2. %1</source>
        <translation>Eine Prüfung, die noch zu speichern war, wurde abgelehnt und ist in %2 aufbewahrt. %1</translation>
    </message>
    <message>
        <source>Not judged: the calibration of the force was overdue by %1 days, and the settings refuse that. Calibrate the force, then squeeze again.</source>
        <translation>Nicht beurteilt: Die Kalibrierung der Kraft war %1 Tage überfällig, und die Einstellungen lassen das nicht zu. Die Kraft kalibrieren, dann erneut drücken.</translation>
    </message>
    <message>
        <source>Not judged: the calibration of the position was overdue by %1 days, and the settings refuse that. Calibrate the position, then squeeze again.</source>
        <translation>Nicht beurteilt: Die Kalibrierung des Wegs war %1 Tage überfällig, und die Einstellungen lassen das nicht zu. Den Weg kalibrieren, dann erneut drücken.</translation>
    </message>
    <message>
        <source>Not judged: nobody is signed in, and the settings ask for somebody. Sign in, then squeeze again.</source>
        <translation>Nicht beurteilt: Niemand ist angemeldet, und die Einstellungen verlangen es. Anmelden, dann erneut drücken.</translation>
    </message>
    <message>
        <source>Not judged: %1 % of the samples were lost, and the settings allow %2 %. Look after cable and hub, then squeeze again.</source>
        <translation>Nicht beurteilt: %L1 % der Abtastwerte gingen verloren, und die Einstellungen erlauben %L2 %. Kabel und Hub prüfen, dann erneut drücken.</translation>
    </message>
    <message>
        <source>the force channel&apos;s noise, %1, was taken from the %2 samples before the squeeze</source>
        <translation>das Rauschen des Kraftkanals, %1, wurde aus den %2 Abtastwerten vor dem Druckversuch bestimmt</translation>
    </message>
    <message>
        <source>found no two columns of numbers</source>
        <translation>gefunden: keine zwei Spalten mit Zahlen</translation>
    </message>
    <message>
        <source>expected a table with commas, semicolons or tabs</source>
        <translation>erwartet: eine Tabelle mit Kommas, Semikolons oder Tabulatoren</translation>
    </message>
    <message>
        <source>the unit of time must have from %1 to %2 seconds</source>
        <translation>die Zeiteinheit muss %L1 bis %L2 Sekunden haben</translation>
    </message>
    <message>
        <source>force, position and time must be columns of their own</source>
        <translation>Kraft, Weg und Zeit müssen je eine eigene Spalte haben</translation>
    </message>
    <message>
        <source>found %1 columns</source>
        <translation>gefunden: %1 Spalten</translation>
    </message>
    <message>
        <source>expected at least %1</source>
        <translation>erwartet: mindestens %1</translation>
    </message>
    <message>
        <source>expected a finite number with a decimal comma</source>
        <translation>erwartet: eine endliche Zahl mit Dezimalkomma</translation>
    </message>
    <message>
        <source>found steps of %1 s in %2</source>
        <translation>gefunden: Schritte von %L1 s in %2</translation>
    </message>
    <message>
        <source>the lag between the channels was never measured: it is taken to be within %1 us of what is assumed, a tenth of the sample time</source>
        <translation>der Zeitversatz der Kanäle wurde nie gemessen: Er gilt als auf %1 µs um den angenommenen bekannt, ein Zehntel der Abtastzeit</translation>
    </message>
    <message>
        <source>the position is counted in steps and its noise is %1 of one only: rounding errors follow the motion</source>
        <translation>der Weg kommt in Stufen, und sein Rauschen beträgt nur %1 einer Stufe: Rundungsfehler folgen der Bewegung</translation>
    </message>
    <message>
        <source>Copying the library</source>
        <translation>Bibliothek kopieren</translation>
    </message>
    <message>
        <source>there is a file of this name already, which is not overwritten</source>
        <translation>eine Datei dieses Namens gibt es schon; sie wird nicht überschrieben</translation>
    </message>
    <message>
        <source>there is nothing in it</source>
        <translation>es steht nichts darin</translation>
    </message>
    <message>
        <source>Putting back the backup</source>
        <translation>Sicherung zurückspielen</translation>
    </message>
    <message>
        <source>be put aside</source>
        <translation>beiseitelegen</translation>
    </message>
    <message>
        <source>tell of the restore</source>
        <translation>das Zurückspielen vermerken</translation>
    </message>
    <message>
        <source>it cannot be replaced</source>
        <translation>sie lässt sich nicht ersetzen</translation>
    </message>
    <message>
        <source>This file is the library itself, not a copy of it.</source>
        <translation>Diese Datei ist die Bibliothek selbst, keine Kopie von ihr.</translation>
    </message>
    <message>
        <source>another program keeps it locked</source>
        <translation>ein anderes Programm hält sie gesperrt</translation>
    </message>
    <message>
        <source>it cannot be written</source>
        <translation>sie lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>what the history is found by</source>
        <translation>wonach der Verlauf durchsucht wird</translation>
    </message>
    <message>
        <source>be copied</source>
        <translation>kopieren</translation>
    </message>
    <message>
        <source>Qt&apos;s SQLite driver does not give its connection</source>
        <translation>der SQLite-Treiber von Qt gibt seine Verbindung nicht heraus</translation>
    </message>
    <message>
        <source>other programs opened it again and again meanwhile</source>
        <translation>andere Programme haben sie währenddessen immer wieder geöffnet</translation>
    </message>
    <message>
        <source>there is a file of this name already</source>
        <translation>eine Datei dieses Namens gibt es schon</translation>
    </message>
    <message>
        <source>be taken out of use</source>
        <translation>außer Gebrauch nehmen</translation>
    </message>
    <message>
        <source>another program has it open, or this one still has. Close the other one, then try again</source>
        <translation>ein anderes Programm hat sie geöffnet, oder dieses noch. Das andere schließen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>count what is in it</source>
        <translation>zählen, was in ihr steht</translation>
    </message>
    <message>
        <source>Put back from a backup, times: %1. The last on %2 (UTC), by %3, from %4, because: %5. What had been stored after that backup is in the library that was kept aside.</source>
        <translation>Aus einer Sicherung zurückgespielt, Anzahl: %1. Zuletzt am %2 (UTC) von %3 aus %4, Grund: %5. Was nach dieser Sicherung gespeichert worden war, steht in der Bibliothek, die beiseitegelegt wurde.</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>einer nicht genannten Person</translation>
    </message>
    <message>
        <source>inspections</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>the library before is kept as</source>
        <translation>die bisherige Bibliothek bleibt als</translation>
    </message>
    <message>
        <source>Library backed up</source>
        <translation>Bibliothek gesichert</translation>
    </message>
    <message>
        <source>Library put aside for a backup</source>
        <translation>Bibliothek für eine Sicherung beiseitegelegt</translation>
    </message>
    <message>
        <source>Backup put back</source>
        <translation>Sicherung zurückgespielt</translation>
    </message>
    <message>
        <source>Putting back a backup of the library</source>
        <translation>Eine Sicherung der Bibliothek zurückspielen</translation>
    </message>
    <message>
        <source>the clock that a squeeze was recorded by</source>
        <translation>die Uhr, nach der ein Druckversuch aufgenommen wurde</translation>
    </message>
    <message>
        <source>m, b, k of the empty gripper</source>
        <translation>m, b, k des leeren Greifers</translation>
    </message>
    <message>
        <source>measured by</source>
        <translation>gemessen durch</translation>
    </message>
    <message>
        <source>by itself, to make room</source>
        <translation>von selbst, um Platz zu schaffen</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>its standard uncertainty in s</source>
        <translation>ihre Standardunsicherheit in s</translation>
    </message>
    <message>
        <source>noise of the force</source>
        <translation>Rauschen der Kraft</translation>
    </message>
    <message>
        <source>uncertainty of the force&apos;s scale</source>
        <translation>Unsicherheit des Kraftmaßstabs</translation>
    </message>
    <message>
        <source>compliance of the frame</source>
        <translation>Nachgiebigkeit des Gestells</translation>
    </message>
    <message>
        <source>uncertainty of the frame&apos;s compliance</source>
        <translation>Unsicherheit der Gestellnachgiebigkeit</translation>
    </message>
    <message>
        <source>hours that a check holds for</source>
        <translation>Stunden, für die eine Kontrolle gilt</translation>
    </message>
    <message>
        <source>newest inspection of before</source>
        <translation>neueste Prüfung davor</translation>
    </message>
    <message>
        <source>newest enrolled squeeze of before, by its version</source>
        <translation>neuester eingelernter Druckversuch davor, nach seiner Version</translation>
    </message>
    <message>
        <source>names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>uncertainty of the position&apos;s scale</source>
        <translation>Unsicherheit des Wegmaßstabs</translation>
    </message>
    <message>
        <source>preload</source>
        <translation>Vorlast</translation>
    </message>
    <message>
        <source>push and release</source>
        <translation>Drücken und Nachlassen</translation>
    </message>
    <message>
        <source>may differ by</source>
        <translation>zulässige Abweichung</translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>Angabe</translation>
    </message>
    <message>
        <source>Local gravity is %1 to %2 m/s² on the ground, not %3.</source>
        <translation>Die örtliche Fallbeschleunigung liegt am Boden zwischen %1 und %2 m/s², nicht bei %3.</translation>
    </message>
    <message>
        <source>An ambient temperature is %1 to %2 °C, not %3.</source>
        <translation>Eine Umgebungstemperatur liegt zwischen %1 und %2 °C, nicht bei %3.</translation>
    </message>
    <message>
        <source>A tolerance is larger than zero, not %1.</source>
        <translation>Eine Toleranz ist größer als null, nicht %1.</translation>
    </message>
    <message>
        <source>certificates of calibrations</source>
        <translation>Zertifikate von Kalibrierungen</translation>
    </message>
    <message>
        <source>a unit of loads or a decision rule is none that is known</source>
        <translation>eine Lasteinheit oder Entscheidungsregel ist unbekannt</translation>
    </message>
    <message>
        <source>this force does not determine m, b and k; squeeze with a richer one</source>
        <translation>diese Kraft bestimmt m, b und k nicht; mit einer frequenzreicheren drücken</translation>
    </message>
    <message>
        <source>the backup that was put back, %1, cannot take its place</source>
        <translation>die zurückgespielte Sicherung %1 kann nicht an ihre Stelle treten</translation>
    </message>
    <message>
        <source>its conditions are none that there can be</source>
        <translation>ihre Bedingungen kann es nicht geben</translation>
    </message>
    <message>
        <source>A point that was checked holds a number that is not finite.</source>
        <translation>Ein nachgeprüfter Punkt enthält eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>Some of the inspections that another program left in %1 wait there until this program is started again: there is no room for more.</source>
        <translation>Ein Teil der Prüfungen, die ein anderes Programm in %1 hinterlassen hat, wartet dort bis zum nächsten Start dieses Programms: Für mehr ist kein Platz.</translation>
    </message>
    <message>
        <source>another program has it</source>
        <translation>ein anderes Programm hat sie</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>Datei %1</translation>
    </message>
    <message>
        <source>Another program has %1.</source>
        <translation>Ein anderes Programm hat %1.</translation>
    </message>
    <message>
        <source>The inspections in %1 were made for another library. Name that one.</source>
        <translation>Die Prüfungen in %1 gehören zu einer anderen Bibliothek. Diese mit --library angeben.</translation>
    </message>
    <message>
        <source>no inspection in it can be read</source>
        <translation>darin lässt sich keine Prüfung lesen</translation>
    </message>
    <message>
        <source>its approval is void</source>
        <translation>die Freigabe ist hinfällig</translation>
    </message>
    <message>
        <source>as expected</source>
        <translation>wie erwartet</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>of a known type</source>
        <translation>von bekanntem Typ</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>one person</source>
        <translation>eine Person</translation>
    </message>
    <message>
        <source>a second person</source>
        <translation>eine zweite Person</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>a part that goes on yielding</source>
        <translation>ein Teil, das weiter nachgibt</translation>
    </message>
    <message>
        <source>a spring that is not straight</source>
        <translation>eine Feder, die nicht gerade ist</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message>
        <source>viscoelastic</source>
        <translation>viskoelastisch</translation>
    </message>
    <message>
        <source>friction, viscoelastic</source>
        <translation>Reibung, viskoelastisch</translation>
    </message>
    <message>
        <source>friction, cubic spring</source>
        <translation>Reibung, kubische Feder</translation>
    </message>
    <message>
        <source>viscoelastic, cubic spring</source>
        <translation>viskoelastisch, kubische Feder</translation>
    </message>
    <message>
        <source>without mass</source>
        <translation>ohne Masse</translation>
    </message>
    <message>
        <source>viscoelastic without mass</source>
        <translation>viskoelastisch ohne Masse</translation>
    </message>
    <message>
        <source>cubic spring without mass</source>
        <translation>kubische Feder ohne Masse</translation>
    </message>
    <message>
        <source>no spring</source>
        <translation>ohne Feder</translation>
    </message>
    <message>
        <source>friction of %1 %2</source>
        <translation>Reibung von %1 %2</translation>
    </message>
    <message>
        <source>a part that goes on yielding by %1 % over %2 s</source>
        <translation>ein Teil, das über %2 s um %1 % weiter nachgibt,</translation>
    </message>
    <message>
        <source>%1 explains this squeeze; without it k would read %2 % high.</source>
        <translation>%1 erklärt diesen Druckversuch; ohne das läse man k um %2 % zu hoch.</translation>
    </message>
    <message>
        <source>%1 explains this squeeze; without it k would read %2 % low.</source>
        <translation>%1 erklärt diesen Druckversuch; ohne das läse man k um %2 % zu niedrig.</translation>
    </message>
    <message>
        <source>the parameters or their errors are outside the range of numbers</source>
        <translation>die Parameter oder ihre Fehler liegen außerhalb des Zahlenbereichs</translation>
    </message>
    <message>
        <source>%1 cannot be told from zero; leave its term out, or squeeze longer and with more levels of force</source>
        <translation>%1 lässt sich nicht von null unterscheiden; das Glied weglassen oder länger und mit mehr Kraftstufen drücken</translation>
    </message>
    <message>
        <source>%1 cannot be told from infinity; leave its term out, or squeeze longer and with more levels of force</source>
        <translation>%1 lässt sich nicht von unendlich unterscheiden; das Glied weglassen oder länger und mit mehr Kraftstufen drücken</translation>
    </message>
    <message>
        <source>friction without a mass is not among the models</source>
        <translation>Reibung ohne Masse gehört nicht zu den Modellen</translation>
    </message>
    <message>
        <source>there are fewer samples than the motion has unknowns; record for longer</source>
        <translation>es sind weniger Abtastwerte als die Bewegung Unbekannte hat; länger aufzeichnen</translation>
    </message>
    <message>
        <source>a constant force does not determine the motion; squeeze with a force that varies, for instance one of four levels</source>
        <translation>eine konstante Kraft bestimmt die Bewegung nicht; mit einer Kraft drücken, die sich ändert, etwa einer mit vier Stufen</translation>
    </message>
    <message>
        <source>friction of the gripper is not known: up to %1 % of the force&apos;s range may hide in this squeeze, and k be %2 % lower; more levels of force tell more of it</source>
        <translation>die Reibung des Greifers ist nicht bekannt: Bis zu %1 % der Kraftspanne können sich in diesem Druckversuch verbergen, und k kann %2 % kleiner sein; mehr Kraftstufen sagen mehr darüber</translation>
    </message>
    <message>
        <source>how the friction begins to slide is not known: over %1 % of the travel m would be %2 % away, b %3 %</source>
        <translation>wie die Reibung zu gleiten beginnt, ist nicht bekannt: über %1 % des Wegs läge m %2 % daneben, b %3 %</translation>
    </message>
    <message>
        <source>the position goes on creeping through the whole squeeze: the part yields, or the sensor drifts. The stiffness that is left in the end is not known; squeeze longer</source>
        <translation>der Weg kriecht den ganzen Druckversuch hindurch weiter: Das Teil gibt nach, oder der Sensor driftet. Die Steifigkeit, die am Ende bleibt, ist nicht bekannt; länger drücken</translation>
    </message>
    <message>
        <source>the part goes on yielding for %1 % of the squeeze: the stiffness that is left in the end is a guess. Squeeze longer</source>
        <translation>das Teil gibt über %1 % des Druckversuchs weiter nach: Die Steifigkeit, die am Ende bleibt, ist geraten. Länger drücken</translation>
    </message>
    <message>
        <source>the squeeze is long enough to see the part yield</source>
        <translation>der Druckversuch ist lang genug, um das Nachgeben zu sehen</translation>
    </message>
    <message>
        <source>the part does not go on yielding</source>
        <translation>das Teil gibt nicht weiter nach</translation>
    </message>
    <message>
        <source>the noise grows with the speed, as when samples are taken %1 us beside their times (standard deviation)</source>
        <translation>das Rauschen wächst mit der Geschwindigkeit, wie bei Abtastwerten, die %1 us neben ihren Zeiten liegen (Standardabweichung)</translation>
    </message>
    <message>
        <source>the force moves the object enough to tell what the motion has</source>
        <translation>die Kraft bewegt das Objekt genug, um zu bestimmen, was die Bewegung hat</translation>
    </message>
    <message>
        <source>what the motion has is above zero; the rest of m, b and k is not in it</source>
        <translation>was die Bewegung hat, ist größer als null; der Rest von m, b und k kommt in ihr nicht vor</translation>
    </message>
    <message>
        <source>how the force of a squeeze goes</source>
        <translation>die Form der Kraft eines Druckversuchs</translation>
    </message>
    <message>
        <source>zener is two numbers, the share of k that yields and its time in seconds, such as 0.2,0.03</source>
        <translation>zener sind zwei Zahlen, der Anteil von k, der nachgibt, und seine Zeit in Sekunden, etwa 0.2,0.03</translation>
    </message>
    <message>
        <source>jitter is at most %1 of the time between two samples, here %2 s</source>
        <translation>jitter ist höchstens das %1-fache der Abtastzeit, hier %2 s</translation>
    </message>
    <message>
        <source>A repeating force takes eight periods of 14 pushes: choose a length of at least %1 s, or a shorter push.</source>
        <translation>Eine wiederholte Kraft braucht acht Perioden zu je 14 Mal Drücken: eine Dauer von mindestens %1 s oder ein kürzeres Drücken wählen.</translation>
    </message>
    <message>
        <source>A sum of sines as long as this has too many tones: choose a longer shortest push, or a shorter squeeze.</source>
        <translation>Eine so lange Summe von Sinus hat zu viele Töne: ein längeres kürzestes Drücken oder einen kürzeren Druckversuch wählen.</translation>
    </message>
    <message>
        <source>friction of the gripper is known: with what the squeeze tells of it, it is up to %1 % of the force&apos;s range, and k may be %2 % lower</source>
        <translation>die Reibung des Greifers ist bekannt: mit dem, was der Druckversuch von ihr zeigt, beträgt sie bis zu %1 % des Kraftbereichs, und k kann %2 % kleiner sein</translation>
    </message>
    <message>
        <source>the friction of a gripper itself</source>
        <translation>die Reibung eines Greifers selbst</translation>
    </message>
    <message>
        <source>friction of the empty gripper</source>
        <translation>Reibung des leeren Greifers</translation>
    </message>
    <message>
        <source>no stiffness was found</source>
        <translation>es wurde keine Steifigkeit gefunden</translation>
    </message>
    <message>
        <source>There is no compliance that was measured well enough to be used.</source>
        <translation>Es gibt keine Nachgiebigkeit, die gut genug gemessen wurde, um verwendet zu werden.</translation>
    </message>
    <message>
        <source>rigid block, %1 squeezes</source>
        <translation>starrer Block, %1 Druckversuche</translation>
    </message>
    <message>
        <source>It is that of the part</source>
        <translation>Sie ist die des Teils</translation>
    </message>
    <message>
        <source>It is that of the part and the fingers together</source>
        <translation>Sie ist die von Teil und Fingern zusammen</translation>
    </message>
    <message>
        <source>k is between %1 and %2 while the force rises from %3 to %4, whatever the position does between its renewals and with clocks that are apart by up to %5 s. %6</source>
        <translation>k liegt zwischen %1 und %2, während die Kraft von %3 auf %4 steigt, was der Weg zwischen seinen Erneuerungen auch tut und mit Uhren, die bis zu %5 s auseinander sind. %6</translation>
    </message>
    <message>
        <source>k is at least %1 while the force rises from %2 to %3, which takes %4 s: with clocks that may be apart by up to %5 s, the part is not told from a rigid one. %6</source>
        <translation>k ist mindestens %1, während die Kraft von %2 auf %3 steigt, was %4 s dauert: Mit Uhren, die bis zu %5 s auseinander sein können, ist das Teil von einem starren nicht zu unterscheiden. %6</translation>
    </message>
    <message>
        <source>k is not told while the force rises from %1 to %2: the clocks may be apart by up to %3 s, and the record does not reach as far before or behind that. Record longer</source>
        <translation>k ist nicht bestimmt, während die Kraft von %1 auf %2 steigt: Die Uhren können bis zu %3 s auseinander sein, und so weit reicht die Aufnahme davor oder danach nicht. Länger aufnehmen</translation>
    </message>
    <message>
        <source>k is not told: the position does not close while the force rises from %1 to %2. Check which column is which, and the grip</source>
        <translation>k ist nicht bestimmt: Die Finger schließen sich nicht, während die Kraft von %1 auf %2 steigt. Prüfen, welche Spalte welche ist, und wie das Teil gehalten wird</translation>
    </message>
    <message>
        <source>the position is renewed only every %1 s, so that no motion is in it: mass and damping cannot be had. Sample force and position by one clock, faster than the part swings; the stiffness alone is told by static</source>
        <translation>der Weg wird nur alle %1 s erneuert und enthält deshalb keine Bewegung: Masse und Dämpfung sind nicht zu haben. Kraft und Weg mit einer Uhr abtasten, schneller als das Teil schwingt; die Steifigkeit allein bestimmt static</translation>
    </message>
    <message>
        <source>the position is renewed only every %1 s: no mass and no damping. %2</source>
        <translation>der Weg wird nur alle %1 s erneuert: keine Masse und keine Dämpfung. %2</translation>
    </message>
    <message>
        <source>the position falls as the force rises: it was read as the opening between the fingers, and its sign was turned</source>
        <translation>der Weg nimmt ab, wenn die Kraft steigt: Er wurde als Öffnung zwischen den Fingern gelesen und sein Vorzeichen umgekehrt</translation>
    </message>
    <message>
        <source>%1 samples outside of contact, where the force reads up to %2, were left out: spikes, or another touch</source>
        <translation>%1 Abtastwerte außerhalb des Kontakts mit Kräften bis zu %2 wurden weggelassen: Ausreißer oder eine weitere Berührung</translation>
    </message>
    <message>
        <source>the position stands still and is renewed only every %1 s, while the force goes on</source>
        <translation>der Weg steht still und wird nur alle %1 s erneuert, während die Kraft weitergeht</translation>
    </message>
    <message>
        <source>The quantities are each near those of the others, but do not go together as theirs do: %1 standard deviations away.</source>
        <translation>Die Größen liegen einzeln nahe denen der anderen, passen aber nicht so zusammen wie bei diesen: %1 Standardabweichungen entfernt.</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>relaxing share</source>
        <translation>Relaxationsanteil</translation>
    </message>
    <message>
        <source>relaxation time</source>
        <translation>Relaxationszeit</translation>
    </message>
    <message>
        <source>%1 is where %2 sits; it is the only type enrolled.</source>
        <translation>%1 liegt, wo %2 liegt; kein anderer Typ ist eingelernt.</translation>
    </message>
    <message>
        <source>Every quantity is where %1 sits; it is the only type enrolled.</source>
        <translation>Jede Größe liegt, wo %1 liegt; kein anderer Typ ist eingelernt.</translation>
    </message>
    <message>
        <source>Each quantity alone could be %1, but not all of them together.</source>
        <translation>Jede Größe könnte einzeln %1 sein, aber nicht alle zusammen.</translation>
    </message>
    <message>
        <source>The squeeze does not determine %1, by which the types are told apart.</source>
        <translation>Aus dem Druckversuch sind nicht bestimmt: %1; danach werden die Typen unterschieden.</translation>
    </message>
    <message>
        <source>Judged by %1 alone: the squeezes enrolled determine no more.</source>
        <translation>Allein nach %1 beurteilt: Mehr bestimmen die eingelernten Druckversuche nicht.</translation>
    </message>
    <message>
        <source>Judged by %1: the squeezes enrolled determine no more.</source>
        <translation>Beurteilt nach %1: Mehr bestimmen die eingelernten Druckversuche nicht.</translation>
    </message>
    <message>
        <source>The squeezes enrolled have no quantity in common to judge by.</source>
        <translation>Die eingelernten Druckversuche haben keine Größe gemeinsam, nach der zu urteilen wäre.</translation>
    </message>
    <message>
        <source>what squeezes determine besides m, b and k</source>
        <translation>was Druckversuche außer m, b und k bestimmen</translation>
    </message>
    <message>
        <source>what it determines is not what its recording does</source>
        <translation>was er bestimmt, ist nicht, was seine Aufzeichnung bestimmt</translation>
    </message>
    <message>
        <source>Judged by %1 alone: the squeeze determines no more.</source>
        <translation>Allein nach %1 beurteilt: Mehr bestimmt der Druckversuch nicht.</translation>
    </message>
    <message>
        <source>Judged by %1: the squeeze determines no more.</source>
        <translation>Beurteilt nach %1: Mehr bestimmt der Druckversuch nicht.</translation>
    </message>
    <message>
        <source>Nothing that parts can be told apart by was found in it.</source>
        <translation>Nichts, woran Teile unterschieden werden können, wurde darin gefunden.</translation>
    </message>
    <message>
        <source>holds a value of another kind than the program writes</source>
        <translation>enthält einen Wert anderer Art, als das Programm schreibt</translation>
    </message>
    <message>
        <source>not judged: what was found has no m, b and k to predict with</source>
        <translation>nicht beurteilt: Was gefunden wurde, hat nicht alle drei von m, b und k, um damit vorherzusagen</translation>
    </message>
    <message>
        <source>m, b and k are above zero and the object swings at less than half the sample rate</source>
        <translation>m, b und k sind größer als null, und das Objekt schwingt mit weniger als der halben Abtastrate</translation>
    </message>
    <message>
        <source>the object found swings at %1 Hz, above half the sample rate. Sample faster.</source>
        <translation>das gefundene Objekt schwingt mit %1 Hz, mehr als der halben Abtastrate. Schneller abtasten.</translation>
    </message>
    <message>
        <source>These samples do not tell a mass: the motion without it explains the squeeze as well.</source>
        <translation>Diese Abtastwerte verraten keine Masse: Die Bewegung ohne sie erklärt den Druckversuch ebenso gut.</translation>
    </message>
    <message>
        <source>with these levels of force friction would pass for stiffness: k is too high by it over half the force&apos;s range. Squeeze with four levels, or characterise the gripper, which tells its own friction</source>
        <translation>bei diesen Kraftstufen ginge Reibung als Steifigkeit durch: k ist um sie, geteilt durch die halbe Spanne der Kraft, zu hoch. Mit vier Stufen drücken oder den Greifer charakterisieren, was seine Reibung ermittelt</translation>
    </message>
    <message>
        <source>The squeeze is where %1 sits, but so would be too many other parts: by %2 alone, more than %3 of those of no enrolled type would be named.</source>
        <translation>Der Druckversuch liegt, wo %1 liegt, zu viele andere Teile aber auch: Allein nach %2 würden mehr als %3 der Fremdteile benannt.</translation>
    </message>
    <message>
        <source>A gripper or a recipe that determines more quantities decides, or a higher stranger-accept rate.</source>
        <translation>Es entscheidet ein Greifer oder ein Rezept, das mehr Größen bestimmt, oder eine höhere Fremdannahme.</translation>
    </message>
    <message>
        <source>Judged by %1 alone, which not every type&apos;s squeezes determine.</source>
        <translation>Allein nach %1 beurteilt, was nicht die Druckversuche aller Typen bestimmen.</translation>
    </message>
    <message>
        <source>Judged by %1, which not every type&apos;s squeezes determine.</source>
        <translation>Beurteilt nach %1, was nicht die Druckversuche aller Typen bestimmen.</translation>
    </message>
    <message>
        <source>levels of a force that somebody has</source>
        <translation>Stufen einer eigenen Kraft</translation>
    </message>
    <message>
        <source>The levels of the recipe&apos;s force are too many, or one is not finite.</source>
        <translation>Die Kraft des Rezepts hat zu viele Stufen, oder eine davon ist nicht endlich.</translation>
    </message>
    <message>
        <source>All that squeezes of %1 determine is where %1 sits.</source>
        <translation>Alles, was Druckversuche von %1 bestimmen, liegt da, wo %1 liegt.</translation>
    </message>
    <message>
        <source>It is a recording that this type has already; a copy says nothing of how its squeezes differ.</source>
        <translation>Diese Aufnahme hat der Typ schon; eine Kopie sagt nichts darüber, wie verschieden seine Druckversuche sind.</translation>
    </message>
    <message>
        <source>there are %1 levels; at most %2 can be squeezed with</source>
        <translation>es sind %1 Stufen; mit höchstens %2 kann gedrückt werden</translation>
    </message>
    <message>
        <source>each level must be from -1 to 1, in parts of the peak</source>
        <translation>jede Stufe muss von -1 bis 1 gehen, in Teilen der Spitze</translation>
    </message>
    <message>
        <source>found a force that is no number, or none</source>
        <translation>eine Kraft, die keine Zahl ist, oder gar keine gefunden</translation>
    </message>
    <message>
        <source>expected a number a step</source>
        <translation>erwartet wird eine Zahl je Schritt</translation>
    </message>
    <message>
        <source>found steps of %1 s</source>
        <translation>Schritte von %1 s gefunden</translation>
    </message>
    <message>
        <source>found the same force throughout</source>
        <translation>überall dieselbe Kraft gefunden</translation>
    </message>
    <message>
        <source>expected one that varies</source>
        <translation>erwartet wird eine, die sich ändert</translation>
    </message>
    <message>
        <source>found %1 levels of force</source>
        <translation>%1 Stufen der Kraft gefunden</translation>
    </message>
    <message>
        <source>expected at most %1: cut it, or take longer steps</source>
        <translation>erwartet werden höchstens %1: kürzen oder längere Schritte nehmen</translation>
    </message>
    <message>
        <source>found row %1 of the table %2 s after the one before</source>
        <translation>Zeile %1 der Tabelle %2 s nach der davor gefunden</translation>
    </message>
    <message>
        <source>expected equal steps, of %1 s</source>
        <translation>erwartet werden gleiche Schritte von %1 s</translation>
    </message>
    <message>
        <source>found forces in %1</source>
        <translation>Kräfte in %1 gefunden</translation>
    </message>
    <message>
        <source>expected one of %1</source>
        <translation>erwartet wird eines von %1</translation>
    </message>
    <message>
        <source>object=%1 is not an object: A, B, C or D, %2, or m,b,k as m in kg (1e-6 to 1e3), b in N s/m (0 to 1e6) and k in N/m (1 to 1e9), such as 0.04,43,9990</source>
        <translation>object=%1 ist kein Objekt: A, B, C oder D, %2 oder m,b,k mit m in kg (1e-6 bis 1e3), b in N s/m (0 bis 1e6) und k in N/m (1 bis 1e9), etwa 0.04,43,9990</translation>
    </message>
    <message>
        <source>There are no levels yet: take those of a file, or let the program search the best two.</source>
        <translation>Es gibt noch keine Stufen: die einer Datei nehmen oder das Programm die besten zwei suchen lassen.</translation>
    </message>
    <message>
        <source>The gripper takes a sample every %1 ms, and these levels are shorter: choose a longer shortest push.</source>
        <translation>Der Greifer tastet alle %1 ms ab, und diese Stufen sind kürzer: ein längeres kürzestes Drücken wählen.</translation>
    </message>
    <message>
        <source>no limit is given: a lower one, an upper one or both</source>
        <translation>es fehlt eine Grenze: eine untere, eine obere oder beide</translation>
    </message>
    <message>
        <source>a limit is no finite number</source>
        <translation>eine Grenze ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the lower limit is not below the upper one</source>
        <translation>die untere Grenze liegt nicht unter der oberen</translation>
    </message>
    <message>
        <source>the deviations of the process and of the measurement are numbers above zero</source>
        <translation>die Standardabweichungen von Prozess und Messung sind Zahlen über null</translation>
    </message>
    <message>
        <source>the mean of the process is no finite number</source>
        <translation>der Mittelwert des Prozesses ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the guard band is no finite number</source>
        <translation>der Sicherheitsabstand ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a risk is between 0 and 1</source>
        <translation>ein Risiko liegt zwischen 0 und 1</translation>
    </message>
    <message>
        <source>a tolerance interval needs two values at least</source>
        <translation>ein Toleranzintervall braucht mindestens zwei Werte</translation>
    </message>
    <message>
        <source>content and confidence are between 0 and 1</source>
        <translation>Anteil und Vertrauensniveau liegen zwischen 0 und 1</translation>
    </message>
    <message>
        <source>a name or a number</source>
        <translation>ein Name oder eine Zahl</translation>
    </message>
    <message>
        <source>%1 is %2 % above %3</source>
        <translation>%1 liegt %2 % über %3</translation>
    </message>
    <message>
        <source>%1 is %2 % below %3</source>
        <translation>%1 liegt %2 % unter %3</translation>
    </message>
    <message>
        <source>%1 %2 is above %3</source>
        <translation>%1 %2 liegt über %3</translation>
    </message>
    <message>
        <source>%1 %2 is below %3</source>
        <translation>%1 %2 liegt unter %3</translation>
    </message>
    <message>
        <source>%1 %2 against %3, the risk not to conform is %4 %</source>
        <translation>%1 %2 gegen %3, das Risiko der Nichtkonformität ist %4 %</translation>
    </message>
    <message>
        <source>how well it knows %1 is not known</source>
        <translation>wie genau er %1 kennt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>it does not determine %1</source>
        <translation>er bestimmt %1 nicht</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>konform</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>nicht konform</translation>
    </message>
    <message>
        <source>too near the limit for this squeeze</source>
        <translation>für diesen Druckversuch zu nahe an der Toleranzgrenze</translation>
    </message>
    <message>
        <source>not decidable by this squeeze</source>
        <translation>mit diesem Druckversuch nicht entscheidbar</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>a limit of m, b or k is not above zero</source>
        <translation>eine Toleranzgrenze von m, b oder k ist nicht größer als null</translation>
    </message>
    <message>
        <source>the consumer&apos;s risk is above 0 and below 0.5</source>
        <translation>das Kundenrisiko liegt über 0 und unter 0,5</translation>
    </message>
    <message>
        <source>Tolerance limits</source>
        <translation>Toleranzgrenzen</translation>
    </message>
    <message>
        <source>store the tolerance limits</source>
        <translation>die Toleranzgrenzen speichern</translation>
    </message>
    <message>
        <source>tolerance limits of parts</source>
        <translation>Toleranzgrenzen von Teilen</translation>
    </message>
    <message>
        <source>%1 no longer has tolerance limits.</source>
        <translation>%1 hat keine Toleranzgrenzen mehr.</translation>
    </message>
    <message>
        <source>The tolerance limits of %1 are %2.</source>
        <translation>Die Toleranzgrenzen von %1 sind %2.</translation>
    </message>
    <message>
        <source>Tolerance limits changed</source>
        <translation>Toleranzgrenzen geändert</translation>
    </message>
    <message>
        <source>study with the key %1</source>
        <translation>Studie mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>The study %1 has ended; nothing is added to it or taken back any more.</source>
        <translation>Die Studie %1 ist beendet; nichts kommt mehr hinzu, nichts wird mehr zurückgenommen.</translation>
    </message>
    <message>
        <source>A measurement of a study has finite numbers and a row of its plan.</source>
        <translation>Eine Messung einer Studie hat endliche Zahlen und eine Zeile ihres Plans.</translation>
    </message>
    <message>
        <source>A study needs a name.</source>
        <translation>Eine Studie braucht einen Namen.</translation>
    </message>
    <message>
        <source>A study needs its kind and its plan.</source>
        <translation>Eine Studie braucht ihre Art und ihren Plan.</translation>
    </message>
    <message>
        <source>begin the study</source>
        <translation>die Studie beginnen</translation>
    </message>
    <message>
        <source>store the measurement</source>
        <translation>die Messung speichern</translation>
    </message>
    <message>
        <source>take the measurement back</source>
        <translation>die Messung zurücknehmen</translation>
    </message>
    <message>
        <source>measurement with the key %1</source>
        <translation>Messung mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>A study ends finished or abandoned.</source>
        <translation>Eine Studie endet abgeschlossen oder abgebrochen.</translation>
    </message>
    <message>
        <source>end the study</source>
        <translation>die Studie beenden</translation>
    </message>
    <message>
        <source>studies of the gripper</source>
        <translation>Studien des Greifers</translation>
    </message>
    <message>
        <source>read the studies</source>
        <translation>die Studien lesen</translation>
    </message>
    <message>
        <source>read the measurements of the study</source>
        <translation>die Messungen der Studie lesen</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>squeeze of the plan</source>
        <translation>Druckversuch des Plans</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>abandoned</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>gauge repeatability and reproducibility</source>
        <translation>Wiederhol- und Vergleichspräzision</translation>
    </message>
    <message>
        <source>type-1 study</source>
        <translation>Verfahren 1</translation>
    </message>
    <message>
        <source>linearity</source>
        <translation>Linearität</translation>
    </message>
    <message>
        <source>attribute agreement</source>
        <translation>Übereinstimmung attributiver Urteile</translation>
    </message>
    <message>
        <source>Study begun</source>
        <translation>Studie begonnen</translation>
    </message>
    <message>
        <source>Study ended</source>
        <translation>Studie beendet</translation>
    </message>
    <message>
        <source>Measurement of a study taken back</source>
        <translation>Messung einer Studie zurückgenommen</translation>
    </message>
    <message>
        <source>No part was judged twice, so that agreement among the raters cannot be seen: let them judge the same parts.</source>
        <translation>Kein Teil wurde zweimal beurteilt, darum ist nicht zu sehen, wie die Beurteilenden übereinstimmen: sie dieselben Teile beurteilen lassen.</translation>
    </message>
    <message>
        <source>All verdicts are the same, so that kappa does not exist: agreement and chance look alike. Take parts of all classes.</source>
        <translation>Alle Urteile sind gleich, darum gibt es kein Kappa: Übereinstimmung und Zufall sehen gleich aus. Teile aller Klassen nehmen.</translation>
    </message>
    <message>
        <source>The verdicts agree well: Fleiss&apos; kappa %1 (z %2).</source>
        <translation>Die Urteile stimmen gut überein: Fleiss’ Kappa %1 (z %2).</translation>
    </message>
    <message>
        <source>The verdicts agree in part only: Fleiss&apos; kappa %1 (z %2). Look at the parts on which they differ, and agree on what counts.</source>
        <translation>Die Urteile stimmen nur teilweise überein: Fleiss’ Kappa %1 (z %2). Die Teile ansehen, bei denen sie auseinandergehen, und vereinbaren, was zählt.</translation>
    </message>
    <message>
        <source>The verdicts agree poorly: Fleiss&apos; kappa %1 (z %2). The parts cannot be judged this way: state what counts, train, and repeat.</source>
        <translation>Die Urteile stimmen schlecht überein: Fleiss’ Kappa %1 (z %2). So lassen sich die Teile nicht beurteilen: festlegen, was zählt, schulen und wiederholen.</translation>
    </message>
    <message>
        <source>%1 judges %2 of the parts right each time; %3 % are needed.</source>
        <translation>%1 beurteilt %2 der Teile jedes Mal richtig; nötig sind %3 %.</translation>
    </message>
    <message>
        <source>%1 accepts %2 of what is not good; %3 % are allowed.</source>
        <translation>%1 nimmt %2 von dem an, was nicht gut ist; erlaubt sind %3 %.</translation>
    </message>
    <message>
        <source>%1 rejects %2 of what is good; %3 % are allowed.</source>
        <translation>%1 weist %2 von dem zurück, was gut ist; erlaubt sind %3 %.</translation>
    </message>
    <message>
        <source>%1 judges only %2 of the parts the same way each time.</source>
        <translation>%1 beurteilt nur %2 der Teile jedes Mal gleich.</translation>
    </message>
    <message>
        <source>%1 has judged no part.</source>
        <translation>%1 hat kein Teil beurteilt.</translation>
    </message>
    <message>
        <source>%1 left %2 of %3 verdicts undecided: they count as not right, but neither as missed nor as false alarms.</source>
        <translation>%1 ließ %2 von %3 Urteilen offen: Sie zählen als nicht richtig, aber weder als übersehen noch als Fehlalarm.</translation>
    </message>
    <message>
        <source>The kappa of %1 against the reference does not exist: both have one class only, the same.</source>
        <translation>Das Kappa von %1 gegen die Referenz gibt es nicht: Beide haben nur eine Klasse, dieselbe.</translation>
    </message>
    <message>
        <source>%1 pairs of raters have no part in common, so that they have no kappa.</source>
        <translation>%1 Paare von Beurteilenden haben kein Teil gemeinsam und darum kein Kappa.</translation>
    </message>
    <message>
        <source>%1 pairs of raters gave all parts the same class, so that their kappa does not exist.</source>
        <translation>%1 Paare von Beurteilenden gaben allen Teilen dieselbe Klasse, darum gibt es ihr Kappa nicht.</translation>
    </message>
    <message>
        <source>Which class is that of good parts is not known, so that misses and false alarms are not counted: name it (--accepted).</source>
        <translation>Welche Klasse die der guten Teile ist, ist nicht bekannt, darum werden Übersehenes und Fehlalarme nicht gezählt: sie nennen (--accepted).</translation>
    </message>
    <message>
        <source>Misses and false alarms count the class %1 against all others.</source>
        <translation>Übersehenes und Fehlalarme zählen die Klasse %1 gegen alle anderen.</translation>
    </message>
    <message>
        <source>%1 parts were not judged by every rater and are left out where all are compared.</source>
        <translation>%1 Teile wurden nicht von allen beurteilt und bleiben weg, wo alle verglichen werden.</translation>
    </message>
    <message>
        <source>No verdict is called %1; there are: %2.</source>
        <translation>Kein Urteil heißt %1; es gibt: %2.</translation>
    </message>
    <message>
        <source>The class %1 cannot be both accepted and undecided.</source>
        <translation>Die Klasse %1 kann nicht zugleich angenommen und unentschieden sein.</translation>
    </message>
    <message>
        <source>The confidence must lie between 0 and 1.</source>
        <translation>Das Vertrauensniveau muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>verdicts</source>
        <translation>Urteile</translation>
    </message>
    <message>
        <source>found the references %1 and %2 for part %3</source>
        <translation>gefunden: die Referenzen %1 und %2 für Teil %3</translation>
    </message>
    <message>
        <source>expected one for each part</source>
        <translation>erwartet: eine für jedes Teil</translation>
    </message>
    <message>
        <source>Name the columns of part, rater and verdict, or those of the raters: either a verdict a row, or a column a rater.</source>
        <translation>Die Spalten von Teil, Beurteilenden und Urteil nennen oder die der Beurteilenden: entweder ein Urteil je Zeile oder eine Spalte je Beurteilenden.</translation>
    </message>
    <message>
        <source>A rater&apos;s column is named twice.</source>
        <translation>Die Spalte eines Beurteilenden ist zweimal genannt.</translation>
    </message>
    <message>
        <source>found no verdict</source>
        <translation>gefunden: kein Urteil</translation>
    </message>
    <message>
        <source>found %1 raters</source>
        <translation>gefunden: %1 Beurteilende</translation>
    </message>
    <message>
        <source>expected at most %1: is it the right column?</source>
        <translation>erwartet: höchstens %1; ist es die richtige Spalte?</translation>
    </message>
    <message>
        <source>found %1 kinds of verdicts</source>
        <translation>gefunden: %1 Arten von Urteilen</translation>
    </message>
    <message>
        <source>readings of the reference parts</source>
        <translation>Anzeigen der Referenzteile</translation>
    </message>
    <message>
        <source>The process variation must be a number above zero.</source>
        <translation>Die Prozessstreuung muss eine Zahl über null sein.</translation>
    </message>
    <message>
        <source>found %1 references and %2 values</source>
        <translation>gefunden: %1 Referenzen und %2 Werte</translation>
    </message>
    <message>
        <source>expected a reference for each value</source>
        <translation>erwartet: eine Referenz für jeden Wert</translation>
    </message>
    <message>
        <source>found a number that is not finite or too large</source>
        <translation>gefunden: eine Zahl, die nicht endlich oder zu groß ist</translation>
    </message>
    <message>
        <source>expected finite numbers</source>
        <translation>erwartet: endliche Zahlen</translation>
    </message>
    <message>
        <source>found %1 different references</source>
        <translation>gefunden: %1 verschiedene Referenzen</translation>
    </message>
    <message>
        <source>expected 2 at least, better 5 over the whole range; for one reference there is the type-1 study</source>
        <translation>erwartet: mindestens 2, besser 5 über den ganzen Bereich; für eine Referenz gibt es die Studie Typ 1</translation>
    </message>
    <message>
        <source>found numbers too large or too small to calculate with</source>
        <translation>gefunden: Zahlen, die zum Rechnen zu groß oder zu klein sind</translation>
    </message>
    <message>
        <source>expected another unit</source>
        <translation>erwartet: eine andere Einheit</translation>
    </message>
    <message>
        <source>The readings lie on the line bias = %1 + %2 reference without any scatter, so that nothing can be tested. Record more digits, or repeat each reference.</source>
        <translation>Die Anzeigen liegen ohne jede Streuung auf der Geraden Abweichung = %1 + %2 Referenz, darum lässt sich nichts prüfen. Mehr Stellen aufzeichnen oder jede Referenz wiederholen.</translation>
    </message>
    <message>
        <source>Linear: neither a bias nor a change of it over the range is seen.</source>
        <translation>Linear: Weder eine Abweichung noch ihre Änderung über den Bereich ist zu sehen.</translation>
    </message>
    <message>
        <source>No single reference shows a bias.</source>
        <translation>Keine einzelne Referenz zeigt eine Abweichung.</translation>
    </message>
    <message>
        <source>A bias is seen at the references %1.</source>
        <translation>Eine Abweichung zeigt sich bei den Referenzen %1.</translation>
    </message>
    <message>
        <source>It cannot be tested at %1, where no scatter is seen: repeat the readings.</source>
        <translation>Nicht prüfbar ist sie bei %1, wo keine Streuung zu sehen ist: die Anzeigen wiederholen.</translation>
    </message>
    <message>
        <source>Over the process variation the bias changes by %1, that is %2 % of it.</source>
        <translation>Über die Prozessstreuung ändert sich die Abweichung um %1, das sind %2 % davon.</translation>
    </message>
    <message>
        <source>There are %1 references with %2 readings at the least; usual are %3 over the whole range with %4 each.</source>
        <translation>Es gibt %1 Referenzen mit mindestens %2 Anzeigen; üblich sind %3 über den ganzen Bereich mit je %4.</translation>
    </message>
    <message>
        <source>readings of the reference part</source>
        <translation>Anzeigen des Referenzteils</translation>
    </message>
    <message>
        <source>expected at least 2, better 50: squeeze the part again</source>
        <translation>erwartet: mindestens 2, besser 50; das Teil noch einmal drücken</translation>
    </message>
    <message>
        <source>The reference must be a finite number.</source>
        <translation>Die Referenz muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>The tolerance must be a number above zero.</source>
        <translation>Die Toleranz muss eine Zahl über null sein.</translation>
    </message>
    <message>
        <source>The share of the tolerance must be above 0 and at most 100 percent.</source>
        <translation>Der Anteil an der Toleranz muss über 0 und höchstens 100 Prozent sein.</translation>
    </message>
    <message>
        <source>The spread must be above 0 and at most 100 standard deviations.</source>
        <translation>Die Spanne muss über 0 und höchstens 100 Standardabweichungen sein.</translation>
    </message>
    <message>
        <source>The minimum of Cg and Cgk must be a number above zero.</source>
        <translation>Das Minimum von Cg und Cgk muss eine Zahl über null sein.</translation>
    </message>
    <message>
        <source>found numbers too large to calculate with</source>
        <translation>gefunden: Zahlen, die zum Rechnen zu groß sind</translation>
    </message>
    <message>
        <source>Not capable: all %1 readings are the same and lie %2 from the reference, more than half of the share of the tolerance that is allowed. Calibrate the gripper.</source>
        <translation>Nicht fähig: Alle %1 Anzeigen sind gleich und liegen %2 von der Referenz, mehr als die Hälfte des erlaubten Anteils an der Toleranz. Den Greifer kalibrieren.</translation>
    </message>
    <message>
        <source>All %1 readings are the same, so that Cg and Cgk do not exist: the scatter is below the step of the readings. Record more digits and repeat the study.</source>
        <translation>Alle %1 Anzeigen sind gleich, darum gibt es Cg und Cgk nicht: Die Streuung liegt unter dem Schritt der Anzeigen. Mehr Stellen aufzeichnen und die Studie wiederholen.</translation>
    </message>
    <message>
        <source>The readings scatter too little for Cg and Cgk to be numbers: check their unit and that of the tolerance.</source>
        <translation>Die Anzeigen streuen zu wenig, als dass Cg und Cgk Zahlen wären: ihre Einheit und die der Toleranz prüfen.</translation>
    </message>
    <message>
        <source>Capable: Cg %1 and Cgk %2 reach %3.</source>
        <translation>Fähig: Cg %1 und Cgk %2 erreichen %3.</translation>
    </message>
    <message>
        <source>Not capable: Cg %1 and Cgk %2, at least %3 is needed. The readings scatter too much: look at fixture, contact and force first, then at the bias.</source>
        <translation>Nicht fähig: Cg %1 und Cgk %2, nötig ist mindestens %3. Die Anzeigen streuen zu sehr: zuerst Aufnahme, Kontakt und Kraft ansehen, dann die Abweichung.</translation>
    </message>
    <message>
        <source>Not capable: Cg %1 and Cgk %2, at least %3 is needed. The readings scatter too much: look at fixture, contact and force.</source>
        <translation>Nicht fähig: Cg %1 und Cgk %2, nötig ist mindestens %3. Die Anzeigen streuen zu sehr: Aufnahme, Kontakt und Kraft ansehen.</translation>
    </message>
    <message>
        <source>Not capable: Cg %1 is enough, Cgk %2 is not, at least %3 is needed. The scatter is small enough, the bias is not: calibrate the gripper and repeat the study.</source>
        <translation>Nicht fähig: Cg %1 genügt, Cgk %2 nicht, nötig ist mindestens %3. Die Streuung ist klein genug, die Abweichung nicht: den Greifer kalibrieren und die Studie wiederholen.</translation>
    </message>
    <message>
        <source>Not capable: Cg %1 and Cgk %2 reach %3, but the step of the readings is too coarse to trust them.</source>
        <translation>Nicht fähig: Cg %1 und Cgk %2 erreichen %3, aber der Schritt der Anzeigen ist zu grob, um ihnen zu trauen.</translation>
    </message>
    <message>
        <source>The mean of the readings lies %1 from the reference; how sure that is cannot be said without scatter.</source>
        <translation>Der Mittelwert der Anzeigen liegt %1 von der Referenz; wie sicher das ist, lässt sich ohne Streuung nicht sagen.</translation>
    </message>
    <message>
        <source>No bias is seen: %1, from %2 to %3 with %4 % confidence.</source>
        <translation>Keine Abweichung zu sehen: %1, von %2 bis %3 mit %4 % Vertrauen.</translation>
    </message>
    <message>
        <source>The gripper reads too much by %1, from %2 to %3 with %4 % confidence.</source>
        <translation>Der Greifer zeigt um %1 zu viel an, von %2 bis %3 mit %4 % Vertrauen.</translation>
    </message>
    <message>
        <source>The gripper reads too little: bias %1, from %2 to %3 with %4 % confidence.</source>
        <translation>Der Greifer zeigt zu wenig an: Abweichung %1, von %2 bis %3 mit %4 % Vertrauen.</translation>
    </message>
    <message>
        <source>The verdict is not certain: with %1 readings Cgk lies between %2 and %3. More readings narrow that.</source>
        <translation>Das Urteil ist nicht sicher: Bei %1 Anzeigen liegt Cgk zwischen %2 und %3. Mehr Anzeigen engen das ein.</translation>
    </message>
    <message>
        <source>The smallest step between the readings is %1, that is %2 % of the tolerance; at most %3 % are allowed. Record more digits, or take a finer sensor.</source>
        <translation>Der kleinste Schritt zwischen den Anzeigen ist %1, das sind %2 % der Toleranz; erlaubt sind höchstens %3 %. Mehr Stellen aufzeichnen oder einen feineren Sensor nehmen.</translation>
    </message>
    <message>
        <source>%1 standard deviations take %2 % of the tolerance; a minimum of %3 allows %4 %. Cg would reach it at a tolerance of %5, Cgk at one of %6.</source>
        <translation>%1 Standardabweichungen nehmen %2 % der Toleranz ein; ein Minimum von %3 erlaubt %4 %. Cg würde es bei einer Toleranz von %5 erreichen, Cgk bei einer von %6.</translation>
    </message>
    <message>
        <source>%1 readings are few: Booklet 10 asks for %2, and for %3 at least. Squeeze the reference part more often.</source>
        <translation>%1 Anzeigen sind wenige: Heft 10 verlangt %2 und mindestens %3. Das Referenzteil öfter drücken.</translation>
    </message>
    <message>
        <source>it is %1</source>
        <translation>er ist %1</translation>
    </message>
    <message>
        <source>a power needs numbers above 0; take percentiles</source>
        <translation>eine Potenz braucht Zahlen über 0; Perzentile nehmen</translation>
    </message>
    <message>
        <source>Value %1</source>
        <translation>Wert %1</translation>
    </message>
    <message>
        <source>The values</source>
        <translation>Die Werte</translation>
    </message>
    <message>
        <source>they are too few, or do not vary</source>
        <translation>sie sind zu wenige oder alle gleich</translation>
    </message>
    <message>
        <source>at least %1 that differ were expected</source>
        <translation>erwartet wurden mindestens %1, die sich unterscheiden</translation>
    </message>
    <message>
        <source>The upper limit</source>
        <translation>Die obere Grenze</translation>
    </message>
    <message>
        <source>The target</source>
        <translation>Der Zielwert</translation>
    </message>
    <message>
        <source>The lower limit</source>
        <translation>Die untere Grenze</translation>
    </message>
    <message>
        <source>The lower limit %1 cannot be passed by values above 0; only the upper one counts.</source>
        <translation>Die untere Grenze %1 können Werte über 0 nicht unterschreiten; nur die obere zählt.</translation>
    </message>
    <message>
        <source>The values are not normal (Anderson-Darling p %1): indices and ppm are not what they seem. Take a distribution by Box and Cox, or percentiles.</source>
        <translation>Die Werte sind nicht normalverteilt (Anderson-Darling, p %1): Kennzahlen und ppm sind nicht, was sie scheinen. Eine Verteilung nach Box und Cox oder Perzentile nehmen.</translation>
    </message>
    <message>
        <source>Too few values to tell whether they are normal.</source>
        <translation>Zu wenige Werte, um zu sagen, ob sie normalverteilt sind.</translation>
    </message>
    <message>
        <source>%1 values tell an index within wide bounds; take at least %2.</source>
        <translation>%1 Werte grenzen eine Kennzahl nur weit ein; mindestens %2 nehmen.</translation>
    </message>
    <message>
        <source>The intervals of Cp and Cpk count %1 degrees of freedom, as is customary; sigma within subgroups is worth %2, and by these the intervals are wider; they stand beside.</source>
        <translation>Die Intervalle von Cp und Cpk zählen %1 Freiheitsgrade, wie es üblich ist; Sigma innerhalb der Untergruppen ist %2 wert, und damit sind die Intervalle breiter; sie stehen daneben.</translation>
    </message>
    <message>
        <source>The values spread more overall than within subgroups: the process moves. Look at its control chart first.</source>
        <translation>Die Werte streuen insgesamt mehr als innerhalb der Untergruppen: Der Prozess wandert. Zuerst seine Regelkarte ansehen.</translation>
    </message>
    <message>
        <source>The confidence must be between 0 and 1.</source>
        <translation>Das Vertrauensniveau muss zwischen 0 und 1 sein.</translation>
    </message>
    <message>
        <source>The target must be a finite number.</source>
        <translation>Der Zielwert muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>Capable: the index is 1.33 or more, and so is the lower end of its interval.</source>
        <translation>Fähig: Die Kennzahl ist 1,33 oder mehr, und ebenso das untere Ende ihres Intervalls.</translation>
    </message>
    <message>
        <source>Probably capable: the index is 1.33 or more, but its interval reaches down to %1. Measure more parts to be sure.</source>
        <translation>Wahrscheinlich fähig: Die Kennzahl ist 1,33 oder mehr, aber ihr Intervall reicht bis %1 hinunter. Mehr Teile messen, um sicher zu sein.</translation>
    </message>
    <message>
        <source>Not capable: the index is below 1, and so is its interval. Centre the process, or make it vary less.</source>
        <translation>Nicht fähig: Die Kennzahl ist unter 1 und ihr Intervall auch. Den Prozess zentrieren oder seine Streuung verringern.</translation>
    </message>
    <message>
        <source>Not capable as it seems: the index is below 1, its interval reaches up to %1. Centre the process, or make it vary less.</source>
        <translation>Wohl nicht fähig: Die Kennzahl ist unter 1, ihr Intervall reicht bis %1 hinauf. Den Prozess zentrieren oder seine Streuung verringern.</translation>
    </message>
    <message>
        <source>Barely capable: the index is between 1 and 1.33. Watch the process, centre it, or make it vary less.</source>
        <translation>Kaum fähig: Die Kennzahl ist zwischen 1 und 1,33. Den Prozess beobachten, zentrieren oder seine Streuung verringern.</translation>
    </message>
    <message>
        <source>The first %1 points cannot settle the limits: there are %2, and at least 2 are needed.</source>
        <translation>Die ersten %1 Punkte können die Grenzen nicht festlegen: Es gibt %2, und mindestens 2 sind nötig.</translation>
    </message>
    <message>
        <source>The subgroups</source>
        <translation>Die Untergruppen</translation>
    </message>
    <message>
        <source>there is one</source>
        <translation>es gibt eine</translation>
    </message>
    <message>
        <source>at least two are needed to settle limits; state target and sigma, or smaller subgroups</source>
        <translation>mindestens zwei sind nötig, um Grenzen festzulegen; Zielwert und Sigma angeben oder kleinere Untergruppen</translation>
    </message>
    <message>
        <source>each holds one value</source>
        <translation>jede enthält einen Wert</translation>
    </message>
    <message>
        <source>take i-mr, ewma or cusum, or larger subgroups</source>
        <translation>i-mr, ewma oder cusum nehmen oder größere Untergruppen</translation>
    </message>
    <message>
        <source>they hold several values each</source>
        <translation>sie enthalten je mehrere Werte</translation>
    </message>
    <message>
        <source>take xbar-r or xbar-s, or leave the subgroups out</source>
        <translation>xbar-r oder xbar-s nehmen oder die Untergruppen weglassen</translation>
    </message>
    <message>
        <source>The limits come from %1 points; they are uncertain themselves. Take at least %2.</source>
        <translation>Die Grenzen stammen aus %1 Punkten; sie sind selbst unsicher. Mindestens %2 nehmen.</translation>
    </message>
    <message>
        <source>The subgroups have %1 to %2 values, and each its own limits.</source>
        <translation>Die Untergruppen haben %1 bis %2 Werte und jede ihre eigenen Grenzen.</translation>
    </message>
    <message>
        <source>%1 subgroups hold one value; they say nothing about sigma.</source>
        <translation>%1 Untergruppen enthalten einen Wert; über Sigma sagen sie nichts.</translation>
    </message>
    <message>
        <source>Run rules are for charts of independent points; on EWMA and CUSUM charts only the limits count.</source>
        <translation>Regeln für Folgen gelten für Karten unabhängiger Punkte; auf EWMA- und CUSUM-Karten zählen nur die Grenzen.</translation>
    </message>
    <message>
        <source>the step from the value before is beyond its limit</source>
        <translation>der Schritt vom Wert davor liegt jenseits seiner Grenze</translation>
    </message>
    <message>
        <source>the values of the subgroup differ more than they should</source>
        <translation>die Werte der Untergruppe unterscheiden sich mehr, als sie sollten</translation>
    </message>
    <message>
        <source>the values of the subgroup differ less than they should</source>
        <translation>die Werte der Untergruppe unterscheiden sich weniger, als sie sollten</translation>
    </message>
    <message>
        <source>the upper sum is above its limit: higher since about point %1</source>
        <translation>die obere Summe liegt über ihrer Grenze: höher seit etwa Punkt %1</translation>
    </message>
    <message>
        <source>the lower sum is above its limit: lower since about point %1</source>
        <translation>die untere Summe liegt über ihrer Grenze: niedriger seit etwa Punkt %1</translation>
    </message>
    <message>
        <source>the moving average is above its limit</source>
        <translation>der gleitende Mittelwert liegt über seiner Grenze</translation>
    </message>
    <message>
        <source>the moving average is below its limit</source>
        <translation>der gleitende Mittelwert liegt unter seiner Grenze</translation>
    </message>
    <message>
        <source>Point %1: %2</source>
        <translation>Punkt %1: %2</translation>
    </message>
    <message>
        <source>Mean and covariance of a T^2 chart do not fit.</source>
        <translation>Mittelwert und Kovarianz einer T²-Karte passen nicht zusammen.</translation>
    </message>
    <message>
        <source>The share of false alarms must be above 0 and at most 0.5.</source>
        <translation>Der Anteil der Fehlalarme muss über 0 und höchstens 0,5 sein.</translation>
    </message>
    <message>
        <source>%1 degrees of freedom for %2 columns</source>
        <translation>%1 Freiheitsgrade für %2 Spalten</translation>
    </message>
    <message>
        <source>at least two more rows than columns, within subgroups where there are any, were expected</source>
        <translation>erwartet wurden mindestens zwei Zeilen mehr als Spalten, innerhalb der Untergruppen, wo es sie gibt</translation>
    </message>
    <message>
        <source>The columns</source>
        <translation>Die Spalten</translation>
    </message>
    <message>
        <source>one of them does not vary, or follows from the others</source>
        <translation>eine von ihnen ändert sich nicht oder folgt aus den anderen</translation>
    </message>
    <message>
        <source>leave that column out</source>
        <translation>diese Spalte weglassen</translation>
    </message>
    <message>
        <source>A row for the chart</source>
        <translation>Eine Zeile für die Karte</translation>
    </message>
    <message>
        <source>it has %1 columns</source>
        <translation>sie hat %1 Spalten</translation>
    </message>
    <message>
        <source>%1 finite numbers were expected</source>
        <translation>%1 endliche Zahlen wurden erwartet</translation>
    </message>
    <message>
        <source>The limits come from few rows (%1 degrees of freedom); take more before they are relied on.</source>
        <translation>Die Grenzen stammen aus wenigen Zeilen (%1 Freiheitsgrade); mehr nehmen, bevor man sich auf sie verlässt.</translation>
    </message>
    <message>
        <source>Point %1: T^2 is above its limit, mostly by %2</source>
        <translation>Punkt %1: T² liegt über seiner Grenze, vor allem durch %2</translation>
    </message>
    <message>
        <source>The centre of a chart must be a finite number.</source>
        <translation>Die Mitte einer Karte muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>The sigma of a chart must be above 0.</source>
        <translation>Das Sigma einer Karte muss über 0 sein.</translation>
    </message>
    <message>
        <source>A subgroup has at least one value.</source>
        <translation>Eine Untergruppe hat mindestens einen Wert.</translation>
    </message>
    <message>
        <source>The weight lambda of an EWMA chart must be above 0 and at most 1.</source>
        <translation>Das Gewicht lambda einer EWMA-Karte muss über 0 und höchstens 1 sein.</translation>
    </message>
    <message>
        <source>The width of an EWMA chart&apos;s limits must be above 0.</source>
        <translation>Die Breite der Grenzen einer EWMA-Karte muss über 0 sein.</translation>
    </message>
    <message>
        <source>The reference value k of a CUSUM chart must not be below 0.</source>
        <translation>Der Referenzwert k einer CUSUM-Karte darf nicht unter 0 sein.</translation>
    </message>
    <message>
        <source>The decision interval h of a CUSUM chart must be above 0.</source>
        <translation>Das Entscheidungsintervall h einer CUSUM-Karte muss über 0 sein.</translation>
    </message>
    <message>
        <source>A subgroup</source>
        <translation>Eine Untergruppe</translation>
    </message>
    <message>
        <source>it has %1 values</source>
        <translation>sie hat %1 Werte</translation>
    </message>
    <message>
        <source>a chart of individuals takes one at a time; take xbar-r or xbar-s</source>
        <translation>eine Karte einzelner Werte nimmt einen nach dem anderen; xbar-r oder xbar-s nehmen</translation>
    </message>
    <message>
        <source>at least one was expected</source>
        <translation>mindestens einer wurde erwartet</translation>
    </message>
    <message>
        <source>A value for the chart</source>
        <translation>Ein Wert für die Karte</translation>
    </message>
    <message>
        <source>it is missing or not finite</source>
        <translation>er fehlt oder ist nicht endlich</translation>
    </message>
    <message>
        <source>leave it out, or measure it again</source>
        <translation>ihn weglassen oder noch einmal messen</translation>
    </message>
    <message>
        <source>The test of normality</source>
        <translation>Die Prüfung auf Normalverteilung</translation>
    </message>
    <message>
        <source>there are %1 values</source>
        <translation>es gibt %1 Werte</translation>
    </message>
    <message>
        <source>at least %1 were expected</source>
        <translation>mindestens %1 wurden erwartet</translation>
    </message>
    <message>
        <source>the values do not vary</source>
        <translation>die Werte ändern sich nicht</translation>
    </message>
    <message>
        <source>record more digits</source>
        <translation>mehr Stellen aufzeichnen</translation>
    </message>
    <message>
        <source>Confidence must be between 0 and 1, and resamples between %1 and %2.</source>
        <translation>Das Vertrauensniveau muss zwischen 0 und 1 sein, die Zahl der Stichproben zwischen %1 und %2.</translation>
    </message>
    <message>
        <source>their percentiles coincide: too many are the same</source>
        <translation>ihre Perzentile fallen zusammen: zu viele sind gleich</translation>
    </message>
    <message>
        <source>The outer percentiles of %1 values are about the smallest and the largest of them: the indices are too good. Take at least %2 values, or a distribution by Box and Cox.</source>
        <translation>Die äußeren Perzentile von %1 Werten sind etwa der kleinste und der größte: Die Kennzahlen sind zu gut. Mindestens %2 Werte nehmen oder eine Verteilung nach Box und Cox.</translation>
    </message>
    <message>
        <source>one point beyond its limits</source>
        <translation>ein Punkt jenseits seiner Grenzen</translation>
    </message>
    <message>
        <source>%1 points in a row on one side of the centre</source>
        <translation>%1 Punkte in Folge auf einer Seite der Mitte</translation>
    </message>
    <message>
        <source>6 points in a row that rise, or fall</source>
        <translation>6 Punkte in Folge, die steigen oder fallen</translation>
    </message>
    <message>
        <source>14 points in a row that alternate up and down</source>
        <translation>14 Punkte in Folge abwechselnd auf und ab</translation>
    </message>
    <message>
        <source>2 of 3 points in a row more than 2 sigma from the centre, on one side</source>
        <translation>2 von 3 Punkten in Folge mehr als 2 Sigma von der Mitte, auf einer Seite</translation>
    </message>
    <message>
        <source>4 of 5 points in a row more than 1 sigma from the centre, on one side</source>
        <translation>4 von 5 Punkten in Folge mehr als 1 Sigma von der Mitte, auf einer Seite</translation>
    </message>
    <message>
        <source>15 points in a row within 1 sigma of the centre</source>
        <translation>15 Punkte in Folge innerhalb 1 Sigma um die Mitte</translation>
    </message>
    <message>
        <source>8 points in a row more than 1 sigma from the centre, on either side</source>
        <translation>8 Punkte in Folge mehr als 1 Sigma von der Mitte, auf beiden Seiten</translation>
    </message>
    <message>
        <source>A subgroup has at least one row.</source>
        <translation>Eine Untergruppe hat mindestens eine Zeile.</translation>
    </message>
    <message>
        <source>there are %1</source>
        <translation>es gibt %1</translation>
    </message>
    <message>
        <source>one for each of the %1 rows of the subgroups was expected, and at least one</source>
        <translation>erwartet wurde einer für jede der %1 Zeilen der Untergruppen und mindestens einer</translation>
    </message>
    <message>
        <source>leave out its row, or measure it again</source>
        <translation>seine Zeile weglassen oder noch einmal messen</translation>
    </message>
    <message>
        <source>moving ranges are of individual values; take ranges or deviations</source>
        <translation>gleitende Spannweiten sind die einzelner Werte; Spannweiten oder Standardabweichungen nehmen</translation>
    </message>
    <message>
        <source>there is one value</source>
        <translation>es gibt einen Wert</translation>
    </message>
    <message>
        <source>at least two are needed to see how values differ</source>
        <translation>mindestens zwei sind nötig, um zu sehen, wie sich Werte unterscheiden</translation>
    </message>
    <message>
        <source>subgroups of at least two, or a chart of individuals, were expected</source>
        <translation>erwartet wurden Untergruppen von mindestens zwei oder eine Karte einzelner Werte</translation>
    </message>
    <message>
        <source>they do not vary within subgroups</source>
        <translation>sie ändern sich innerhalb der Untergruppen nicht</translation>
    </message>
    <message>
        <source>record more digits, or state sigma</source>
        <translation>mehr Stellen aufzeichnen oder Sigma angeben</translation>
    </message>
    <message>
        <source>%1 combinations of part, operator and station that are not balanced</source>
        <translation>%1 Kombinationen von Teil, Bediener und Station, die nicht ausgewogen sind</translation>
    </message>
    <message>
        <source>at most %1, or as many measurements of each; a sample of the parts will do</source>
        <translation>höchstens %1, oder von jeder gleich viele Messungen; eine Stichprobe der Teile genügt</translation>
    </message>
    <message>
        <source>Parts and operators of the table</source>
        <translation>Teile und Bediener der Tabelle</translation>
    </message>
    <message>
        <source>each operator measured one part only, which nobody else measured</source>
        <translation>jeder Bediener hat nur ein Teil gemessen, das sonst niemand gemessen hat</translation>
    </message>
    <message>
        <source>operators who measure several parts each, or no operator column (then all counts as one operator)</source>
        <translation>Bediener, die je mehrere Teile messen, oder keine Spalte der Bediener (dann gilt alles als ein Bediener)</translation>
    </message>
    <message>
        <source>no part was measured by two operators</source>
        <translation>kein Teil wurde von zwei Bedienern gemessen</translation>
    </message>
    <message>
        <source>the same parts for all operators, or a nested design</source>
        <translation>dieselben Teile für alle Bediener, oder ein geschachtelter Plan</translation>
    </message>
    <message>
        <source>The labels of the runs repeat under the parts: taken as nested, runs counted anew within each part. Where a label means the same under every part, choose the crossed design (--design crossed).</source>
        <translation>Die Namen der Durchgänge wiederholen sich bei den Teilen: als geschachtelt genommen, Durchgänge in jedem Teil neu gezählt. Wo ein Name bei jedem Teil dasselbe bedeutet, den gekreuzten Plan wählen (--design crossed).</translation>
    </message>
    <message>
        <source>Taken as nested: the operators (runs) are numbered within each part.</source>
        <translation>Als geschachtelt genommen: die Bediener (Läufe) sind innerhalb jedes Teils nummeriert.</translation>
    </message>
    <message>
        <source>Taken as nested: each operator has parts of their own.</source>
        <translation>Als geschachtelt genommen: jeder Bediener hat eigene Teile.</translation>
    </message>
    <message>
        <source>Labels of operators repeat under the parts: taken as operators (runs) numbered within each part. Where the operators have parts of their own, say so (--inside part) or give each part a name of its own.</source>
        <translation>Die Namen der Bediener wiederholen sich bei den Teilen: als Bediener (Durchgänge) genommen, die in jedem Teil neu gezählt sind. Wo die Bediener eigene Teile haben, das sagen (--inside part) oder jedem Teil einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>Labels of parts repeat under the operators: taken as parts of each operator&apos;s own. Where operators (runs) are numbered within each part, say so (--inside operator) or give each a name of its own.</source>
        <translation>Die Namen der Teile wiederholen sich bei den Bedienern: als eigene Teile jedes Bedieners genommen. Wo Bediener (Durchgänge) in jedem Teil gezählt sind, das sagen (--inside operator) oder jedem einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>Taken as crossed: an operator&apos;s label means the same operator under every part. Where operators (runs) are numbered anew within each part, or parts within each operator, choose the nested design (--design nested).</source>
        <translation>Als gekreuzt genommen: Der Name eines Bedieners meint bei jedem Teil denselben. Wo Bediener (Durchgänge) in jedem Teil neu gezählt sind oder Teile bei jedem Bediener, den geschachtelten Plan wählen (--design nested).</translation>
    </message>
    <message>
        <source>%1 of %2 combinations of part, operator and station were not measured: the components are estimated by restricted maximum likelihood (REML).</source>
        <translation>%1 von %2 Kombinationen von Teil, Bediener und Station wurden nicht gemessen: die Komponenten werden mit der eingeschränkten Maximum-Likelihood-Methode (REML) geschätzt.</translation>
    </message>
    <message>
        <source>Not every combination was measured equally often: the components are estimated by restricted maximum likelihood (REML).</source>
        <translation>Nicht jede Kombination wurde gleich oft gemessen: die Komponenten werden mit der eingeschränkten Maximum-Likelihood-Methode (REML) geschätzt.</translation>
    </message>
    <message>
        <source>No operator measured a part twice: the interaction of part and operator cannot be told from repeatability and counts as part of it. Repeat each measurement at least once to see it.</source>
        <translation>Kein Bediener hat ein Teil zweimal gemessen: die Wechselwirkung von Teil und Bediener ist von der Wiederholpräzision nicht zu trennen und zählt zu ihr. Jede Messung mindestens einmal wiederholen, um sie zu sehen.</translation>
    </message>
    <message>
        <source>No part was measured twice at a station: the interaction of part and station cannot be told from repeatability and counts as part of it. Repeat each measurement at least once to see it.</source>
        <translation>Kein Teil wurde an einer Station zweimal gemessen: die Wechselwirkung von Teil und Station ist von der Wiederholpräzision nicht zu trennen und zählt zu ihr. Jede Messung mindestens einmal wiederholen, um sie zu sehen.</translation>
    </message>
    <message>
        <source>No operator (run) measured a part twice: operators cannot be told from repeatability and count as part of it.</source>
        <translation>Kein Bediener (Lauf) hat ein Teil zweimal gemessen: Bediener sind von der Wiederholpräzision nicht zu trennen und zählen zu ihr.</translation>
    </message>
    <message>
        <source>one part only</source>
        <translation>nur ein Teil</translation>
    </message>
    <message>
        <source>at least two parts, better ten, that differ as production does</source>
        <translation>mindestens zwei Teile, besser zehn, die sich unterscheiden wie die Fertigung</translation>
    </message>
    <message>
        <source>There is one operator only: nothing is known about differences between operators.</source>
        <translation>Es gibt nur einen Bediener: über Unterschiede zwischen Bedienern ist nichts bekannt.</translation>
    </message>
    <message>
        <source>There is one station only: nothing is known about differences between stations.</source>
        <translation>Es gibt nur eine Station: über Unterschiede zwischen Stationen ist nichts bekannt.</translation>
    </message>
    <message>
        <source>each part was measured once</source>
        <translation>jedes Teil wurde einmal gemessen</translation>
    </message>
    <message>
        <source>repeated measurements of the same parts, without which nothing is known about the gripper</source>
        <translation>wiederholte Messungen derselben Teile, ohne die über den Greifer nichts bekannt ist</translation>
    </message>
    <message>
        <source>Column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>values beyond 1e150</source>
        <translation>Werte jenseits von 1e150</translation>
    </message>
    <message>
        <source>values in another unit</source>
        <translation>Werte in einer anderen Einheit</translation>
    </message>
    <message>
        <source>all values are equal</source>
        <translation>alle Werte sind gleich</translation>
    </message>
    <message>
        <source>values with more digits: finer than the parts differ</source>
        <translation>Werte mit mehr Stellen: feiner, als sich die Teile unterscheiden</translation>
    </message>
    <message>
        <source>values that differ by less than 1e-150</source>
        <translation>Werte, die sich um weniger als 1e-150 unterscheiden</translation>
    </message>
    <message>
        <source>The method of moments serves balanced tables: REML was used in its place.</source>
        <translation>Die Momentenmethode gilt für ausgewogene Tabellen: an ihrer Stelle wurde REML verwendet.</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>Wiederholpräzision</translation>
    </message>
    <message>
        <source>the operators</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>the interaction of part and operator</source>
        <translation>Wechselwirkung von Teil und Bediener</translation>
    </message>
    <message>
        <source>the stations</source>
        <translation>Stationen</translation>
    </message>
    <message>
        <source>the interaction of part and station</source>
        <translation>Wechselwirkung von Teil und Station</translation>
    </message>
    <message>
        <source>the parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>the gauge</source>
        <translation>Messmittel</translation>
    </message>
    <message>
        <source>This gripper is good enough to judge these parts: the gauge takes %1 % of the study variation (below 10 %).</source>
        <translation>Dieser Greifer ist gut genug, um diese Teile zu beurteilen: das Messmittel nimmt %1 % der Studienstreuung ein (unter 10 %).</translation>
    </message>
    <message>
        <source>This gripper may do, depending on what is at stake: the gauge takes %1 % of the study variation (up to 10 % is good, above 30 % is not).</source>
        <translation>Dieser Greifer mag genügen, je nachdem, was auf dem Spiel steht: das Messmittel nimmt %1 % der Studienstreuung ein (bis 10 % ist gut, über 30 % nicht).</translation>
    </message>
    <message>
        <source>This gripper is not good enough to judge these parts: the gauge takes %1 % of the study variation (at most 30 %, better 10 %).</source>
        <translation>Dieser Greifer ist nicht gut genug, um diese Teile zu beurteilen: das Messmittel nimmt %1 % der Studienstreuung ein (höchstens 30 %, besser 10 %).</translation>
    </message>
    <message>
        <source> It takes %1 % of the tolerance.</source>
        <translation> Es nimmt %1 % der Toleranz ein.</translation>
    </message>
    <message>
        <source>Nothing of the gauge was seen at all: its repeats are equal. Check that the values have enough digits and that no row was copied.</source>
        <translation>Vom Messmittel war gar nichts zu sehen: seine Wiederholungen sind gleich. Prüfen, ob die Werte genug Stellen haben und keine Zeile kopiert wurde.</translation>
    </message>
    <message>
        <source>It cannot tell these parts apart.</source>
        <translation>Er kann diese Teile nicht unterscheiden.</translation>
    </message>
    <message>
        <source>It tells %1 kinds of part apart, where five are the least.</source>
        <translation>Er unterscheidet %1 Klassen von Teilen; fünf sind das Mindeste.</translation>
    </message>
    <message>
        <source>It tells %1 kinds of part apart.</source>
        <translation>Er unterscheidet %1 Klassen von Teilen.</translation>
    </message>
    <message>
        <source> With so few measurements it may be as few as %1.</source>
        <translation> Bei so wenigen Messungen können es auch nur %1 sein.</translation>
    </message>
    <message>
        <source>Most of the variance comes from %1 (%2 %)</source>
        <translation>Der größte Teil der Varianz: %1 (%2 %)</translation>
    </message>
    <message>
        <source>, most of the gauge&apos;s own from %1 (%2 % of it).</source>
        <translation>, von der des Messmittels: %1 (%2 % davon).</translation>
    </message>
    <message>
        <source>Operators make %1 % of the variance.</source>
        <translation>Bediener machen %1 % der Varianz aus.</translation>
    </message>
    <message>
        <source>Stations make %1 % of the variance.</source>
        <translation>Stationen machen %1 % der Varianz aus.</translation>
    </message>
    <message>
        <source>Next: use it, and repeat the study after repairs, new fingers or a new operator.</source>
        <translation>Weiter: ihn verwenden, und die Studie nach Reparaturen, mit neuen Fingern oder einem neuen Bediener wiederholen.</translation>
    </message>
    <message>
        <source>Next: reduce what comes from %1, then repeat the study; until then let one operator at one station measure what is to be compared.</source>
        <translation>Weiter: vermindern, was hiervon kommt: %1; dann die Studie wiederholen. Bis dahin misst ein Bediener an einer Station, was verglichen werden soll.</translation>
    </message>
    <message>
        <source>Next: squeeze each part %1 times and take the mean, or make the squeeze itself repeat better (stronger or longer excitation, a firmer seat), then repeat the study.</source>
        <translation>Weiter: jedes Teil %1-mal drücken und mitteln, oder den Druckversuch selbst wiederholbarer machen (stärkere oder längere Anregung, festerer Sitz), dann die Studie wiederholen.</translation>
    </message>
    <message>
        <source>Next: make the squeeze itself repeat better (stronger or longer excitation, a firmer seat), and choose parts that differ as production does, then repeat the study.</source>
        <translation>Weiter: den Druckversuch selbst wiederholbarer machen (stärkere oder längere Anregung, festerer Sitz) und Teile wählen, die sich unterscheiden wie die Fertigung, dann die Studie wiederholen.</translation>
    </message>
    <message>
        <source>Pooled: %1 is not seen (F = %2, p = %3, above %4) and counts as repeatability; without pooling it is kept.</source>
        <translation>Zusammengefasst: nicht zu sehen ist %1 (F = %2, p = %3, über %4) und zählt zur Wiederholpräzision; ohne Zusammenfassen bleibt es stehen.</translation>
    </message>
    <message>
        <source>The estimated variance of %1 is negative (%2) and is taken as 0 in all sums: it is too small for this table to see.</source>
        <translation>Die geschätzte Varianz (%1) ist negativ (%2) und gilt in allen Summen als 0: sie ist zu klein, um in dieser Tabelle gesehen zu werden.</translation>
    </message>
    <message>
        <source>The variance of %1 is estimated as 0, the least that it can be: it is too small for this table to see.</source>
        <translation>Die Varianz (%1) wird auf 0 geschätzt, das Kleinste, was sie sein kann: sie ist zu klein, um in dieser Tabelle gesehen zu werden.</translation>
    </message>
    <message>
        <source>The likelihood was not maximised to the last digits: take the components as approximate.</source>
        <translation>Die Likelihood wurde nicht bis auf die letzten Stellen maximiert: die Komponenten als Näherung nehmen.</translation>
    </message>
    <message>
        <source>The values cannot be judged together: one of them repeats exactly, or is determined by the others.</source>
        <translation>Die Werte lassen sich nicht gemeinsam beurteilen: einer wiederholt sich genau oder ist durch die anderen bestimmt.</translation>
    </message>
    <message>
        <source>Along some combination of the values the parts&apos; estimated variance is negative; it is taken as 0.</source>
        <translation>Entlang einer Kombination der Werte ist die geschätzte Varianz der Teile negativ; sie gilt als 0.</translation>
    </message>
    <message>
        <source>The range method serves balanced tables of parts and operators alone, each operator measuring each part equally often. Use the analysis of variance or REML.</source>
        <translation>Die Spannweitenmethode gilt für ausgewogene Tabellen aus Teilen und Bedienern allein, in denen jeder Bediener jedes Teil gleich oft misst. Die Varianzanalyse oder REML verwenden.</translation>
    </message>
    <message>
        <source>The range method: nothing was measured twice, so there are no ranges of trials. Repeat each measurement.</source>
        <translation>Spannweitenmethode: nichts wurde zweimal gemessen, also gibt es keine Spannweiten der Durchgänge. Jede Messung wiederholen.</translation>
    </message>
    <message>
        <source>The range method: at most %1 parts and %1 trials; use the analysis of variance.</source>
        <translation>Spannweitenmethode: höchstens %1 Teile und %1 Durchgänge; die Varianzanalyse verwenden.</translation>
    </message>
    <message>
        <source>The range method: too many operators; use the analysis of variance instead.</source>
        <translation>Spannweitenmethode: zu viele Bediener; stattdessen die Varianzanalyse verwenden.</translation>
    </message>
    <message>
        <source>Uncertainty of measurement %1</source>
        <translation>Unsicherheit der Messung %1</translation>
    </message>
    <message>
        <source>above 0</source>
        <translation>über 0</translation>
    </message>
    <message>
        <source>Operators cannot be told from the other columns, which determine them: left out.</source>
        <translation>Bediener sind von den anderen Spalten nicht zu trennen, die sie bestimmen: weggelassen.</translation>
    </message>
    <message>
        <source>Stations cannot be told from the other columns, which determine them: left out.</source>
        <translation>Stationen sind von den anderen Spalten nicht zu trennen, die sie bestimmen: weggelassen.</translation>
    </message>
    <message>
        <source>The interaction of part and operator cannot be told from the other effects in this table: left out.</source>
        <translation>Die Wechselwirkung von Teil und Bediener ist in dieser Tabelle von den anderen Wirkungen nicht zu trennen: weggelassen.</translation>
    </message>
    <message>
        <source>The interaction of part and station cannot be told from the other effects in this table: left out.</source>
        <translation>Die Wechselwirkung von Teil und Station ist in dieser Tabelle von den anderen Wirkungen nicht zu trennen: weggelassen.</translation>
    </message>
    <message>
        <source>value column %1: all its values are equal</source>
        <translation>Wertespalte %1: alle ihre Werte sind gleich</translation>
    </message>
    <message>
        <source>parts cannot be told from operators or stations</source>
        <translation>Teile sind von Bedienern oder Stationen nicht zu trennen</translation>
    </message>
    <message>
        <source>several parts for each operator and station</source>
        <translation>mehrere Teile für jeden Bediener und jede Station</translation>
    </message>
    <message>
        <source>nothing was measured twice</source>
        <translation>nichts wurde zweimal gemessen</translation>
    </message>
    <message>
        <source>repeated measurements, without which repeatability is not known</source>
        <translation>wiederholte Messungen, ohne die die Wiederholpräzision nicht bekannt ist</translation>
    </message>
    <message>
        <source>The plan of a study</source>
        <translation>Der Plan einer Studie</translation>
    </message>
    <message>
        <source>kind, order, quantity and seed of a study</source>
        <translation>Art, Reihenfolge, Größe und Startwert einer Studie</translation>
    </message>
    <message>
        <source>1 to %1 rows</source>
        <translation>1 bis %1 Zeilen</translation>
    </message>
    <message>
        <source>places in the lists of the plan</source>
        <translation>Plätze in den Listen des Plans</translation>
    </message>
    <message>
        <source>Put in part %1 (trial %2 of %3).</source>
        <translation>Teil %1 einlegen (Durchgang %2 von %3).</translation>
    </message>
    <message>
        <source>%1 puts in part %2 (trial %3 of %4).</source>
        <translation>%1 legt Teil %2 ein (Durchgang %3 von %4).</translation>
    </message>
    <message>
        <source> At station %1.</source>
        <translation> An Station %1.</translation>
    </message>
    <message>
        <source>All %1 squeezes are through.</source>
        <translation>Alle %1 Druckversuche sind gemacht.</translation>
    </message>
    <message>
        <source>Squeeze %1 of %2.</source>
        <translation>Druckversuch %1 von %2.</translation>
    </message>
    <message>
        <source> Left out: %1.</source>
        <translation> Ausgelassen: %1.</translation>
    </message>
    <message>
        <source> Repeated: %1.</source>
        <translation> Wiederholt: %1.</translation>
    </message>
    <message>
        <source>The labels of a study differ: one is there twice.</source>
        <translation>Die Bezeichnungen einer Studie müssen verschieden sein: eine ist doppelt.</translation>
    </message>
    <message>
        <source>A label of a study has 1 to %1 characters.</source>
        <translation>Eine Bezeichnung einer Studie hat 1 bis %1 Zeichen.</translation>
    </message>
    <message>
        <source>A study against references needs one for each part.</source>
        <translation>Eine Studie gegen Referenzen braucht eine für jedes Teil.</translation>
    </message>
    <message>
        <source>A reference value is a number.</source>
        <translation>Ein Referenzwert ist eine Zahl.</translation>
    </message>
    <message>
        <source>A study has 1 to %1 squeezes of at least one part.</source>
        <translation>Eine Studie hat 1 bis %1 Druckversuche an mindestens einem Teil.</translation>
    </message>
    <message>
        <source>A gauge study needs two parts or more, each measured twice or more often. Ten parts, three operators and three trials are usual.</source>
        <translation>Eine Messmittelstudie braucht mindestens zwei Teile, jedes mindestens zweimal gemessen. Üblich sind zehn Teile, drei Bediener und drei Durchgänge.</translation>
    </message>
    <message>
        <source>A type-1 study is one part, squeezed by one person again and again: 50 times is usual, 25 the least that is.</source>
        <translation>Verfahren 1 ist ein Teil, von einer Person immer wieder gedrückt: üblich sind 50-mal, mindestens 25-mal.</translation>
    </message>
    <message>
        <source>Linearity needs two references or more. Five parts over the range, twelve trials each, are usual.</source>
        <translation>Linearität braucht mindestens zwei Referenzen. Üblich sind fünf Teile über den Bereich, je zwölf Durchgänge.</translation>
    </message>
    <message>
        <source>Attribute agreement needs two parts or more, and two raters or two trials. 50 parts, three raters and three trials are usual.</source>
        <translation>Die Übereinstimmung attributiver Urteile braucht mindestens zwei Teile und zwei Prüfer oder zwei Durchgänge. Üblich sind 50 Teile, drei Prüfer und drei Durchgänge.</translation>
    </message>
    <message>
        <source>It does not determine m, b and k.</source>
        <translation>Er bestimmt m, b und k nicht.</translation>
    </message>
    <message>
        <source>The study %1</source>
        <translation>Die Studie %1</translation>
    </message>
    <message>
        <source>no quantity that all squeezes determined</source>
        <translation>keine Größe, die alle Druckversuche bestimmt haben</translation>
    </message>
    <message>
        <source>measurements of m, b or k</source>
        <translation>Messungen von m, b oder k</translation>
    </message>
    <message>
        <source>measurements in several units</source>
        <translation>Messungen in mehreren Einheiten</translation>
    </message>
    <message>
        <source>measurements in one unit</source>
        <translation>Messungen in einer Einheit</translation>
    </message>
    <message>
        <source>No study is under way. Begin one, or go on with one.</source>
        <translation>Es läuft keine Studie. Eine beginnen oder mit einer weitermachen.</translation>
    </message>
    <message>
        <source>All squeezes of the study are through. Finish it.</source>
        <translation>Alle Druckversuche der Studie sind gemacht. Die Studie abschließen.</translation>
    </message>
    <message>
        <source>The study was begun with gripper %1, and %2 is connected. Connect the first one, or begin a study of its own.</source>
        <translation>Die Studie wurde mit Greifer %1 begonnen, verbunden ist %2. Den ersten verbinden oder eine eigene Studie beginnen.</translation>
    </message>
    <message>
        <source>A study is under way. Finish or abandon it first.</source>
        <translation>Es läuft eine Studie. Sie zuerst abschließen oder abbrechen.</translation>
    </message>
    <message>
        <source>What a rater says of a part is a word of a study of attributes.</source>
        <translation>Was ein Prüfer über ein Teil sagt, ist ein Wort einer attributiven Studie.</translation>
    </message>
    <message>
        <source>There is nothing to take back.</source>
        <translation>Es gibt nichts zurückzunehmen.</translation>
    </message>
    <message>
        <source>%1 squeezes are left. Make them, or say why the study ends without them.</source>
        <translation>%1 Druckversuche fehlen noch. Sie machen, oder begründen, warum die Studie ohne sie endet.</translation>
    </message>
    <message>
        <source>All repeats of %1 are equal, so nothing is known of how well it is measured.</source>
        <translation>Alle Wiederholungen von %1 sind gleich; wie gut es gemessen wird, ist damit nicht bekannt.</translation>
    </message>
    <message>
        <source>This gripper does not tell these parts apart by %1.</source>
        <translation>Dieser Greifer unterscheidet diese Teile nicht nach %1.</translation>
    </message>
    <message>
        <source>This gripper tells %1 kinds of %2 apart.</source>
        <translation>Dieser Greifer unterscheidet %1 Klassen von %2.</translation>
    </message>
    <message>
        <source>Operators are not the trouble.</source>
        <translation>An den Bedienern liegt es nicht.</translation>
    </message>
    <message>
        <source>Operators are the trouble: they make %1 % of the gauge&apos;s variance in %2.</source>
        <translation>Es liegt an den Bedienern: sie machen %1 % der Varianz des Messmittels bei %2 aus.</translation>
    </message>
    <message>
        <source>Operators differ, but squeezes of one operator differ more: operators make %1 % of the gauge&apos;s variance in %2.</source>
        <translation>Die Bediener unterscheiden sich, die Druckversuche eines Bedieners aber mehr: Bediener machen %1 % der Varianz des Messmittels bei %2 aus.</translation>
    </message>
    <message>
        <source>%1 is a whole number from 1 to %2</source>
        <translation>%1 ist eine ganze Zahl von 1 bis %2</translation>
    </message>
    <message>
        <source>virtual: knows object, seed, noise, speed, friction, own-friction, zener, k3, rate, jitter, part, operator, trial, part-spread, operator-spread, repeat-spread, fault, script, capture, profile and like</source>
        <translation>virtual: kennt object, seed, noise, speed, friction, own-friction, zener, k3, rate, jitter, part, operator, trial, part-spread, operator-spread, repeat-spread, fault, script, capture, profile und like</translation>
    </message>
    <message>
        <source>The last squeezes of %1 lie beside its enrolment, more than chance leaves: its charts are beyond their limits. Look at the next ones.</source>
        <translation>Die letzten Druckversuche von %1 liegen weiter neben dem Einlernen, als der Zufall erklärt: Die Regelkarten sind über ihren Grenzen. Auf die nächsten achten.</translation>
    </message>
    <message>
        <source>A type-1 study needs the tolerance of its quantity.</source>
        <translation>Eine Typ-1-Studie braucht die Toleranz ihrer Größe.</translation>
    </message>
    <message>
        <source>a squeeze without its quantity or reference</source>
        <translation>ein Druckversuch ohne seine Größe oder Referenz</translation>
    </message>
    <message>
        <source>the quantity of the study from every squeeze</source>
        <translation>die Größe der Studie aus jedem Druckversuch</translation>
    </message>
    <message>
        <source>Not linear: the bias changes by %1 for each unit of the reference (%2). Calibrate the gripper at both ends of its range, then repeat the study.</source>
        <translation>Nicht linear: Die Abweichung ändert sich um %1 je Einheit der Referenz (%2). Den Greifer an beiden Enden seines Bereichs kalibrieren, dann die Studie wiederholen.</translation>
    </message>
    <message>
        <source>Linear, but biased: the zero line is not within what the readings allow (%1); the mean bias is %2. Take it off by a calibration, then repeat the study.</source>
        <translation>Linear, aber mit Abweichung: Die Nulllinie liegt nicht in dem, was die Anzeigen zulassen (%1); die mittlere Abweichung ist %2. Sie durch eine Kalibrierung abziehen, dann die Studie wiederholen.</translation>
    </message>
    <message>
        <source>A straight line does not describe the bias (lack of fit, %1): go by the bias at each reference, and calibrate with a curve.</source>
        <translation>Eine Gerade beschreibt die Abweichung nicht (mangelnde Anpassung, %1): nach der Abweichung bei jeder Referenz gehen und mit einer Kurve kalibrieren.</translation>
    </message>
    <message>
        <source>Operators differ from part to part (interaction, %1): they grip some parts differently. Look where, and how those parts are put in.</source>
        <translation>Die Bediener unterscheiden sich von Teil zu Teil (Wechselwirkung, %1): manche Teile greifen sie anders. Nachsehen, wo, und wie diese Teile eingelegt werden.</translation>
    </message>
    <message>
        <source>Stations differ from part to part (interaction, %1). Look at which parts, and how they sit there.</source>
        <translation>Die Stationen unterscheiden sich von Teil zu Teil (Wechselwirkung, %1). Nachsehen, bei welchen Teilen, und wie sie dort sitzen.</translation>
    </message>
    <message>
        <source>Operators matter: they differ (%1) and make %2 % of the variance. Agree on one way to put the part in and to start.</source>
        <translation>Die Bediener zählen: sie unterscheiden sich (%1) und machen %2 % der Varianz aus. Eine gemeinsame Art vereinbaren, das Teil einzulegen und zu starten.</translation>
    </message>
    <message>
        <source>Stations matter: they differ (%1) and make %2 % of the variance. Calibrate them against each other.</source>
        <translation>Die Stationen zählen: sie unterscheiden sich (%1) und machen %2 % der Varianz aus. Sie gegeneinander kalibrieren.</translation>
    </message>
    <message>
        <source>Operators are not the trouble: no difference between them is seen (%1).</source>
        <translation>An den Bedienern liegt es nicht: zwischen ihnen ist kein Unterschied zu sehen (%1).</translation>
    </message>
    <message>
        <source>Stations are not the trouble: no difference between them is seen (%1).</source>
        <translation>An den Stationen liegt es nicht: zwischen ihnen ist kein Unterschied zu sehen (%1).</translation>
    </message>
    <message>
        <source>Repeats scatter %1 times as much as the squeezes&apos; own uncertainties say (%2): something that a squeeze does not see, such as how the part sits, differs from squeeze to squeeze.</source>
        <translation>Wiederholungen streuen %1-mal so stark, wie die eigenen Unsicherheiten der Druckversuche sagen (%2): etwas, das ein Druckversuch nicht sieht, etwa wie das Teil sitzt, ändert sich von einem zum anderen.</translation>
    </message>
    <message>
        <source>Repeats scatter only %1 times as much as the squeezes&apos; own uncertainties say (%2): these are stated too large, or hold what all squeezes have in common.</source>
        <translation>Wiederholungen streuen nur %1-mal so stark, wie die eigenen Unsicherheiten der Druckversuche sagen (%2): diese sind zu groß angegeben oder enthalten, was allen Druckversuchen gemeinsam ist.</translation>
    </message>
    <message>
        <source>Repeats scatter as the squeezes&apos; own uncertainties say (%1 times, %2).</source>
        <translation>Wiederholungen streuen so, wie die eigenen Unsicherheiten der Druckversuche sagen (%1-mal, %2).</translation>
    </message>
    <message>
        <source>Together the values tell up to %1 combinations apart, as many as that only where parts come in all of them; the best of them alone (%2) tells %3 kinds of part.</source>
        <translation>Zusammen unterscheiden die Werte bis zu %1 Kombinationen, so viele aber nur, wo es Teile in allen gibt; der beste allein (%2) unterscheidet %3 Klassen von Teilen.</translation>
    </message>
    <message>
        <source>nothing that counts was measured</source>
        <translation>nichts gemessen, was zählt</translation>
    </message>
    <message>
        <source>a squeeze or a verdict of every part</source>
        <translation>ein Druckversuch oder ein Urteil von jedem Teil</translation>
    </message>
    <message>
        <source>By %1 together it tells more than %2 combinations apart, such as stiff and light from stiff and heavy, where parts come in all of them.</source>
        <translation>Nach %1 zusammen unterscheidet er mehr als %2 Kombinationen, etwa steif und leicht von steif und schwer, wo es Teile in allen gibt.</translation>
    </message>
    <message>
        <source>By %1 together it tells up to %2 combinations apart, such as stiff and light from stiff and heavy, where parts come in all of them.</source>
        <translation>Nach %1 zusammen unterscheidet er bis zu %2 Kombinationen, etwa steif und leicht von steif und schwer, wo es Teile in allen gibt.</translation>
    </message>
    <message>
        <source>The heartbeat of the PLC stands still.</source>
        <translation>Das Lebenszeichen der SPS steht still.</translation>
    </message>
    <message>
        <source>The heartbeat of the PLC stands still. The gripper was stopped and disarmed; arm it again when the PLC is back.</source>
        <translation>Das Lebenszeichen der SPS steht still. Der Greifer wurde gestoppt und entschärft; neu scharf schalten, wenn die SPS wieder da ist.</translation>
    </message>
    <message>
        <source>Part %1 was not inspected: %2</source>
        <translation>Teil %1 wurde nicht geprüft: %2</translation>
    </message>
    <message>
        <source>its squeeze did not come to its end.</source>
        <translation>sein Druckversuch kam nicht zum Ende.</translation>
    </message>
    <message>
        <source>No PLC connected since %1.</source>
        <translation>Keine SPS verbunden seit %1.</translation>
    </message>
    <message>
        <source>A PLC is connected, and its heartbeat stands still: it has to write another number all the time.</source>
        <translation>Eine SPS ist verbunden, und ihr Lebenszeichen steht still: Sie muss ständig eine andere Zahl schreiben.</translation>
    </message>
    <message>
        <source>%1 was turned away: it is not among the addresses that may connect.</source>
        <translation>%1 wurde abgewiesen: nicht unter den Adressen, die sich verbinden dürfen.</translation>
    </message>
    <message>
        <source>PLC has not acknowledged result %1.</source>
        <translation>Die SPS hat Ergebnis %1 nicht quittiert.</translation>
    </message>
    <message>
        <source>PLC: off</source>
        <translation>SPS: aus</translation>
    </message>
    <message>
        <source>PLC: not listening</source>
        <translation>SPS: nicht erreichbar</translation>
    </message>
    <message>
        <source>PLC: in step</source>
        <translation>SPS: im Takt</translation>
    </message>
    <message>
        <source>PLC: see why</source>
        <translation>SPS: siehe</translation>
    </message>
    <message>
        <source>the PLC has not acknowledged the result before</source>
        <translation>die SPS hat das Ergebnis davor nicht quittiert</translation>
    </message>
    <message>
        <source>the part before is still being inspected</source>
        <translation>das Teil davor wird noch geprüft</translation>
    </message>
    <message>
        <source>the gripper is not armed; a person at the station has to arm it</source>
        <translation>der Greifer ist nicht scharf; eine Person an der Station muss ihn scharf schalten</translation>
    </message>
    <message>
        <source>the station is not ready; see what it says of its gripper</source>
        <translation>die Station ist nicht bereit; siehe, was sie über ihren Greifer sagt</translation>
    </message>
    <message>
        <source>no type has that number at this station; see its list of types</source>
        <translation>an dieser Station hat kein Typ diese Nummer; siehe ihre Liste der Typen</translation>
    </message>
    <message>
        <source>the heartbeat of the PLC stands still</source>
        <translation>das Lebenszeichen der SPS steht still</translation>
    </message>
    <message>
        <source>it is not the number that is next; the PLC has to read the last trigger that was answered</source>
        <translation>es ist nicht die nächste Nummer; die SPS muss den zuletzt beantworteten Auslöser lesen</translation>
    </message>
    <message>
        <source>Trigger %1 for part %2 was refused: %3.</source>
        <translation>Auslöser %1 für Teil %2 wurde abgelehnt: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no network address; 127.0.0.1 listens to this computer alone, 0.0.0.0 to all networks.</source>
        <translation>„%1“ ist keine Netzadresse; 127.0.0.1 hört nur auf diesen Rechner, 0.0.0.0 auf alle Netze.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a network address nor a network such as 10.1.2.0/24.</source>
        <translation>„%1“ ist weder eine Netzadresse noch ein Netz wie 10.1.2.0/24.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no HOST:PORT such as 127.0.0.1:1502.</source>
        <translation>„%1“ ist kein HOST:PORT wie 127.0.0.1:1502.</translation>
    </message>
    <message>
        <source>Nothing can listen on %1:%2 (%3). Choose another address or port.</source>
        <translation>Auf %1:%2 kann nicht gehört werden (%3). Andere Adresse oder anderen Port wählen.</translation>
    </message>
    <message>
        <source>The squeezes of gripper %1 are adjusted to types that were enrolled on another; a type that is enrolled here would be judged wrongly. Enrol it on the other gripper, or withdraw the adjustment.</source>
        <translation>Die Druckversuche des Greifers %1 werden an Typen angepasst, die an einem anderen eingelernt wurden; ein hier eingelernter Typ würde falsch beurteilt. Ihn am anderen Greifer einlernen oder die Anpassung zurückziehen.</translation>
    </message>
    <message>
        <source>This gripper has no serial number to keep its adjustment under.</source>
        <translation>Dieser Greifer hat keine Seriennummer, unter der seine Anpassung aufbewahrt werden könnte.</translation>
    </message>
    <message>
        <source>Say why the gripper is adjusted.</source>
        <translation>Angeben, warum der Greifer angepasst wird.</translation>
    </message>
    <message>
        <source>An adjustment holds a number that is not finite.</source>
        <translation>Eine Anpassung enthält eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>%1 was enrolled on this gripper itself: adjusted, its parts would be judged wrongly. Enrol it on the other gripper or retire it first.</source>
        <translation>%1 wurde an diesem Greifer selbst eingelernt: Angepasst würden seine Teile falsch beurteilt. Ihn zuerst am anderen Greifer einlernen oder außer Gebrauch nehmen.</translation>
    </message>
    <message>
        <source>store the adjustment</source>
        <translation>die Anpassung speichern</translation>
    </message>
    <message>
        <source>Say why the adjustment is withdrawn.</source>
        <translation>Angeben, warum die Anpassung zurückgezogen wird.</translation>
    </message>
    <message>
        <source>adjustment with the key %1</source>
        <translation>Anpassung mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>withdraw the adjustment</source>
        <translation>die Anpassung zurückziehen</translation>
    </message>
    <message>
        <source>fix the limits of the charts</source>
        <translation>die Grenzen der Regelkarten festlegen</translation>
    </message>
    <message>
        <source>what control charts are drawn from</source>
        <translation>woraus Regelkarten gezeichnet werden</translation>
    </message>
    <message>
        <source>adjustments of grippers</source>
        <translation>Anpassungen von Greifern</translation>
    </message>
    <message>
        <source>The adjustment of this gripper is older than its calibration of %1: what was corrected then may be corrected twice. Measure the adjustment again, or withdraw it.</source>
        <translation>Die Anpassung dieses Greifers ist älter als seine Kalibrierung vom %1: Was dabei berichtigt wurde, wird womöglich doppelt berichtigt. Die Anpassung neu messen oder zurückziehen.</translation>
    </message>
    <message>
        <source>%1 was enrolled on this gripper itself, whose squeezes are adjusted to another: its parts are judged wrongly. Enrol it on the other gripper, or withdraw the adjustment.</source>
        <translation>%1 wurde an diesem Greifer selbst eingelernt, dessen Druckversuche an einen anderen angepasst werden: Seine Teile werden falsch beurteilt. Ihn am anderen Greifer einlernen oder die Anpassung zurückziehen.</translation>
    </message>
    <message>
        <source>read the adjustments of grippers</source>
        <translation>die Anpassungen von Greifern lesen</translation>
    </message>
    <message>
        <source>The adjustment of gripper %1</source>
        <translation>Die Anpassung des Greifers %1</translation>
    </message>
    <message>
        <source>its numbers are not those that were stored</source>
        <translation>ihre Zahlen sind nicht die gespeicherten</translation>
    </message>
    <message>
        <source>read the limits of the charts</source>
        <translation>die Grenzen der Regelkarten lesen</translation>
    </message>
    <message>
        <source>types on another gripper</source>
        <translation>Typen an einem anderen Greifer</translation>
    </message>
    <message>
        <source>Gripper adjusted to types of another</source>
        <translation>Greifer an Typen eines anderen angepasst</translation>
    </message>
    <message>
        <source>Adjustment of a gripper withdrawn</source>
        <translation>Anpassung eines Greifers zurückgezogen</translation>
    </message>
    <message>
        <source>Adjusting a gripper to types of another</source>
        <translation>Einen Greifer an Typen eines anderen anpassen</translation>
    </message>
    <message>
        <source>Types on another gripper need each two squeezes or more there. Five of each are usual.</source>
        <translation>Typen an einem anderen Greifer brauchen dort je zwei Druckversuche oder mehr. Fünf je Typ sind üblich.</translation>
    </message>
    <message>
        <source>By the other squeezes that was a part of %1, not of %2. Take it back if the wrong part was in.</source>
        <translation>Nach den anderen Druckversuchen war das ein Teil von %1, nicht von %2. Zurücknehmen, wenn das falsche Teil eingelegt war.</translation>
    </message>
    <message>
        <source>By the other squeezes that was no part of %1. Take it back if the wrong part was in; if it was the right one, this type is not common to both grippers.</source>
        <translation>Nach den anderen Druckversuchen war das kein Teil von %1. Zurücknehmen, wenn das falsche Teil eingelegt war; war es das richtige, ist dieser Typ nicht beiden Greifern gemeinsam.</translation>
    </message>
    <message>
        <source>The inspections</source>
        <translation>Die Prüfungen</translation>
    </message>
    <message>
        <source>their m, b and k are in units that cannot be compared</source>
        <translation>ihre m, b und k haben Einheiten, die sich nicht vergleichen lassen</translation>
    </message>
    <message>
        <source>choose one gripper, or state the units of its channels</source>
        <translation>einen Greifer wählen, oder die Einheiten seiner Kanäle angeben</translation>
    </message>
    <message>
        <source>The charts of %1 signal. %2.</source>
        <translation>Die Regelkarten von %1 melden. %2.</translation>
    </message>
    <message>
        <source>m, b and k together are beyond their limit, mostly by %1</source>
        <translation>m, b und k zusammen sind jenseits ihrer Grenze, vor allem durch %1</translation>
    </message>
    <message>
        <source>the upper sum is above its limit: the values have risen</source>
        <translation>die obere Summe ist über ihrer Grenze: die Werte sind gestiegen</translation>
    </message>
    <message>
        <source>the lower sum is above its limit: the values have fallen</source>
        <translation>die untere Summe ist über ihrer Grenze: die Werte sind gefallen</translation>
    </message>
    <message>
        <source>above the upper limit</source>
        <translation>über der oberen Grenze</translation>
    </message>
    <message>
        <source>below the lower limit</source>
        <translation>unter der unteren Grenze</translation>
    </message>
    <message>
        <source>%1 at inspection %2: %3</source>
        <translation>%1 bei Prüfung %2: %3</translation>
    </message>
    <message>
        <source>%1 at inspection %2: %3, since inspection %4</source>
        <translation>%1 bei Prüfung %2: %3, seit Prüfung %4</translation>
    </message>
    <message>
        <source>How seldom a false signal comes cannot be told for this chart.</source>
        <translation>Wie selten ein falsches Signal kommt, lässt sich für diese Karte nicht sagen.</translation>
    </message>
    <message>
        <source>While nothing changes, one point in %1 signals by chance; once m, b and k have moved together by one standard deviation, a signal comes within %2 points on average.</source>
        <translation>Solange sich nichts ändert, meldet einer von %1 Punkten zufällig; haben sich m, b und k zusammen um eine Standardabweichung verschoben, kommt im Mittel innerhalb von %2 Punkten ein Signal.</translation>
    </message>
    <message>
        <source>While nothing changes, one point in %1 signals by chance on each chart; once a quantity has moved by one sigma, a signal comes within %2 points on average.</source>
        <translation>Solange sich nichts ändert, meldet auf jeder Karte einer von %1 Punkten zufällig; hat sich eine Größe um ein Sigma verschoben, kommt im Mittel innerhalb von %2 Punkten ein Signal.</translation>
    </message>
    <message>
        <source>Types on another gripper are judged squeeze by squeeze.</source>
        <translation>Typen an einem anderen Greifer werden Druckversuch für Druckversuch beurteilt.</translation>
    </message>
    <message>
        <source>inspection %1 of %2</source>
        <translation>Prüfung %1 vom %2</translation>
    </message>
    <message>
        <source>It was so from the first of these inspections on: the change is older.</source>
        <translation>Es war so ab der ersten dieser Prüfungen: Die Änderung ist älter.</translation>
    </message>
    <message>
        <source>Since %1.</source>
        <translation>Seit %1.</translation>
    </message>
    <message>
        <source>With 95 % between %1 and %2.</source>
        <translation>Mit 95 % zwischen %1 und %2.</translation>
    </message>
    <message>
        <source>That was in the batch %1.</source>
        <translation>Das war im Los %1.</translation>
    </message>
    <message>
        <source>No adjustment yet: it takes %1 squeezes of each type, of two types or more.</source>
        <translation>Noch keine Anpassung: Nötig sind %1 Druckversuche je Typ, von zwei Typen oder mehr.</translation>
    </message>
    <message>
        <source>Too few squeezes of %1: %2 of each type are the least, since one that went wrong is not seen among two.</source>
        <translation>Zu wenige Druckversuche von %1: %2 je Typ sind das Mindeste, da ein misslungener unter zweien nicht auffällt.</translation>
    </message>
    <message>
        <source>So far of one type only: whether others need the same adjustment shows with a second.</source>
        <translation>Bisher nur von einem Typ: Ob andere dieselbe Anpassung brauchen, zeigt ein zweiter.</translation>
    </message>
    <message>
        <source>The adjustment is known well enough: %1 (95 %). More squeezes would change no verdict.</source>
        <translation>Die Anpassung ist gut genug bekannt: %1 (95 %). Weitere Druckversuche würden kein Urteil ändern.</translation>
    </message>
    <message>
        <source>Known so far to %1 (95 %). %2 more squeezes of each type bring that to %3, a third of what squeezes of one type scatter: then it widens no verdict.</source>
        <translation>Bisher bekannt auf %1 (95 %). %2 weitere Druckversuche je Typ bringen das auf %3, ein Drittel dessen, was Druckversuche eines Typs streuen: Dann weitet sie kein Urteil.</translation>
    </message>
    <message>
        <source>Known so far to %1 (95 %). More squeezes here help little: the enrolment of the types is not known better. Its uncertainty counts in every verdict.</source>
        <translation>Bisher bekannt auf %1 (95 %). Weitere Druckversuche helfen hier wenig: Das Einlernen der Typen ist nicht besser bekannt. Die Unsicherheit zählt in jedem Urteil.</translation>
    </message>
    <message>
        <source>%1 and %2 need different adjustments: one of them is not common to both grippers, or a wrong part was in. A third type tells which.</source>
        <translation>%1 und %2 brauchen verschiedene Anpassungen: Einer davon ist nicht beiden Greifern gemeinsam, oder ein falsches Teil war eingelegt. Ein dritter Typ sagt, welcher.</translation>
    </message>
    <message>
        <source>%1 does not fit the adjustment of the others: not the same parts on both grippers, or a wrong part was in. Leave it out, or squeeze it again.</source>
        <translation>%1 passt nicht zur Anpassung der anderen: nicht dieselben Teile an beiden Greifern, oder ein falsches Teil war eingelegt. Auslassen oder noch einmal drücken.</translation>
    </message>
    <message>
        <source>the recording of a measurement</source>
        <translation>die Aufnahme einer Messung</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>reading and writing</source>
        <translation>Lesen und Schreiben</translation>
    </message>
    <message>
        <source>%1 (it belongs to %2, group %3, %4)</source>
        <translation>%1 (gehört %2, Gruppe %3, %4)</translation>
    </message>
    <message>
        <source>What is missing is %1.</source>
        <translation>Es fehlt: %1.</translation>
    </message>
    <message>
        <source>not looked at</source>
        <translation>nicht angesehen</translation>
    </message>
    <message>
        <source>there is none yet</source>
        <translation>es gibt noch keine</translation>
    </message>
    <message>
        <source>Keep the file as it is and go on with a backup: gripscope-cli library restore. gripscope-cli library verify --library %1 tells all.</source>
        <translation>Die Datei aufheben, wie sie ist, und mit einer Sicherung weiterarbeiten: gripscope-cli library restore. gripscope-cli library verify --library %1 sagt alles.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>%1 is not there yet; it is made when it is first needed</source>
        <translation>%1 gibt es noch nicht; wird angelegt, sobald sie gebraucht wird</translation>
    </message>
    <message>
        <source>%1, version %2 of the schema</source>
        <translation>%1, Version %2 des Schemas</translation>
    </message>
    <message>
        <source>A newer program wrote it; this one knows version %1. Install the newer one.</source>
        <translation>Ein neueres Programm hat sie geschrieben; dieses kennt Version %1. Das neuere installieren.</translation>
    </message>
    <message>
        <source>The program brings it to version %1 when it opens it; make a copy before: gripscope-cli library backup.</source>
        <translation>Das Programm bringt sie beim Öffnen auf Version %1; vorher eine Kopie machen: gripscope-cli library backup.</translation>
    </message>
    <message>
        <source>Integrity</source>
        <translation>Unversehrtheit</translation>
    </message>
    <message>
        <source>%1 rows are as they were written</source>
        <translation>%1 Zeilen sind, wie sie geschrieben wurden</translation>
    </message>
    <message>
        <source>%1 differences; the first: %2</source>
        <translation>%1 Abweichungen; die erste: %2</translation>
    </message>
    <message>
        <source>Ledger</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>%1: %2 links</source>
        <translation>%1: %2 Glieder</translation>
    </message>
    <message>
        <source>nothing has been written yet</source>
        <translation>noch nichts geschrieben</translation>
    </message>
    <message>
        <source>%1; this computer does not know them</source>
        <translation>%1; dieser Rechner kennt sie nicht</translation>
    </message>
    <message>
        <source>That is so when the library came from elsewhere. Otherwise ask who changed it: its end may be missing.</source>
        <translation>So ist es, wenn die Bibliothek von anderswo kam. Sonst fragen, wer sie geändert hat: Ihr Ende kann fehlen.</translation>
    </message>
    <message>
        <source>%1; not all signed</source>
        <translation>%1; nicht alle signiert</translation>
    </message>
    <message>
        <source>See to the key of this station, the line below.</source>
        <translation>Nach dem Schlüssel dieser Station sehen, die Zeile darunter.</translation>
    </message>
    <message>
        <source>%1; their ends are those that this computer knows</source>
        <translation>%1; ihre Enden sind die, die dieser Rechner kennt</translation>
    </message>
    <message>
        <source>Key of this station</source>
        <translation>Schlüssel der Station</translation>
    </message>
    <message>
        <source>%1 may not be read by this user</source>
        <translation>%1 darf dieser Benutzer nicht lesen</translation>
    </message>
    <message>
        <source>Type this in a terminal: %1</source>
        <translation>In ein Terminal eingeben: %1</translation>
    </message>
    <message>
        <source>others may read or change %1</source>
        <translation>andere dürfen %1 lesen oder ändern</translation>
    </message>
    <message>
        <source>%1, this user&apos;s alone</source>
        <translation>%1, nur für diesen Benutzer</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Datenträger</translation>
    </message>
    <message>
        <source>nothing may be written in %1</source>
        <translation>in %1 darf nichts geschrieben werden</translation>
    </message>
    <message>
        <source>how much is free in %1 is not known</source>
        <translation>wie viel in %1 frei ist, ist nicht bekannt</translation>
    </message>
    <message>
        <source>See to it that its disk is there.</source>
        <translation>Dafür sorgen, dass der Datenträger da ist.</translation>
    </message>
    <message>
        <source>%1 GB free in %2</source>
        <translation>%1 GB frei in %2</translation>
    </message>
    <message>
        <source>Make room, or move the library to a larger disk.</source>
        <translation>Platz schaffen oder die Bibliothek auf einen größeren Datenträger legen.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>no gripper is plugged in, and none was calibrated</source>
        <translation>kein Greifer ist angesteckt, und keiner wurde kalibriert</translation>
    </message>
    <message>
        <source>%1 has none of its %2</source>
        <translation>%1 hat keine (%2)</translation>
    </message>
    <message>
        <source>%1, %2: was due on %3</source>
        <translation>%1, %2: war fällig am %3</translation>
    </message>
    <message>
        <source>%1, %2: is due on %3</source>
        <translation>%1, %2: ist fällig am %3</translation>
    </message>
    <message>
        <source>%1, %2: holds until %3</source>
        <translation>%1, %2: gilt bis %3</translation>
    </message>
    <message>
        <source>Calibrate these channels on the page Calibrate.</source>
        <translation>Diese Kanäle auf der Seite Kalibrieren kalibrieren.</translation>
    </message>
    <message>
        <source>Set the clock; by the network, type this in a terminal: sudo timedatectl set-ntp true</source>
        <translation>Die Uhr stellen; über das Netz, in ein Terminal eingeben: sudo timedatectl set-ntp true</translation>
    </message>
    <message>
        <source>it says %1, which is long gone</source>
        <translation>sie sagt %1, was lange her ist</translation>
    </message>
    <message>
        <source>it says %1, but the library was written at %2</source>
        <translation>sie sagt %1, aber die Bibliothek wurde um %2 geschrieben</translation>
    </message>
    <message>
        <source>%1; whether it is kept right is not known here</source>
        <translation>%1; ob sie richtig gehalten wird, ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>Neither timedatectl nor chronyc answers: compare it with another clock.</source>
        <translation>Weder timedatectl noch chronyc antworten: mit einer anderen Uhr vergleichen.</translation>
    </message>
    <message>
        <source>%1, not kept right by the network (%2)</source>
        <translation>%1, nicht vom Netz gestellt (%2)</translation>
    </message>
    <message>
        <source>%1, kept right by the network (%2)</source>
        <translation>%1, vom Netz gestellt (%2)</translation>
    </message>
    <message>
        <source>Permissions</source>
        <translation>Zugriffsrechte</translation>
    </message>
    <message>
        <source>%1 may be opened</source>
        <translation>%1 darf geöffnet werden</translation>
    </message>
    <message>
        <source>%1 (%2): what is missing is %3</source>
        <translation>%1 (%2): es fehlt: %3</translation>
    </message>
    <message>
        <source>no gripper is plugged in; one may be opened</source>
        <translation>kein Greifer ist angesteckt; einer dürfte geöffnet werden</translation>
    </message>
    <message>
        <source>no gripper is plugged in, and no rule lets this user open one</source>
        <translation>kein Greifer ist angesteckt, und keine Regel lässt diesen Benutzer einen öffnen</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>The program was built with Qt %1: install the package that was built for this system.</source>
        <translation>Das Programm wurde mit Qt %1 gebaut: das Paket installieren, das für dieses System gebaut wurde.</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>chart</source>
        <translation>Regelkarte</translation>
    </message>
    <message>
        <source>from inspection</source>
        <translation>ab Prüfung</translation>
    </message>
    <message>
        <source>to inspection</source>
        <translation>bis Prüfung</translation>
    </message>
    <message>
        <source>sigma</source>
        <translation>Sigma</translation>
    </message>
    <message>
        <source>Limits of control charts fixed</source>
        <translation>Grenzen von Regelkarten festgelegt</translation>
    </message>
    <message>
        <source>Limits of control charts released</source>
        <translation>Grenzen von Regelkarten freigegeben</translation>
    </message>
    <message>
        <source>Chance alone would make some %1 of them.</source>
        <translation>Der Zufall allein ergäbe etwa %1 davon.</translation>
    </message>
    <message>
        <source>MQTT needs the name or address of a broker, and its port.</source>
        <translation>MQTT braucht Name oder Adresse eines Brokers und seinen Port.</translation>
    </message>
    <message>
        <source>MQTT needs a topic for JSON, or the group and edge node of Sparkplug B.</source>
        <translation>MQTT braucht ein Topic für JSON oder Gruppe und Edge Node von Sparkplug B.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no topic to send to: it must have neither + nor #, and not begin with $ or spBv1.0.</source>
        <translation>An „%1“ kann nichts gesendet werden: Ein Topic enthält weder + noch # und beginnt nicht mit $ oder spBv1.0.</translation>
    </message>
    <message>
        <source>Sparkplug B needs both, a group and an edge node.</source>
        <translation>Sparkplug B braucht beides, eine Gruppe und einen Edge Node.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of Sparkplug B: it must have neither /, + nor #.</source>
        <translation>„%1“ ist kein Name für Sparkplug B: Er darf weder /, + noch # enthalten.</translation>
    </message>
    <message>
        <source>MQTT needs the name of the user that the password is of.</source>
        <translation>MQTT braucht den Namen des Benutzers, zu dem das Passwort gehört.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no HOST:PORT such as broker.example:1883.</source>
        <translation>„%1“ ist kein HOST:PORT wie broker.example:1883.</translation>
    </message>
    <message>
        <source>Everybody on this computer can read the password in %1. Let only its owner read it (chmod 600).</source>
        <translation>Jeder an diesem Rechner kann das Passwort in %1 lesen. Nur der Eigentümer darf es lesen (chmod 600).</translation>
    </message>
    <message>
        <source>another program on this computer sends the results of this library</source>
        <translation>ein anderes Programm auf diesem Rechner sendet die Ergebnisse dieser Bibliothek</translation>
    </message>
    <message>
        <source>The broker %1 does not speak MQTT 3.1.1.</source>
        <translation>Der Broker %1 spricht kein MQTT 3.1.1.</translation>
    </message>
    <message>
        <source>The broker %1 refuses this station&apos;s name.</source>
        <translation>Der Broker %1 weist den Namen dieser Station ab.</translation>
    </message>
    <message>
        <source>The broker %1 is there, and takes nobody at the moment.</source>
        <translation>Der Broker %1 ist da, nimmt aber zurzeit niemanden an.</translation>
    </message>
    <message>
        <source>The broker %1 wants a user and a password.</source>
        <translation>Der Broker %1 verlangt Benutzer und Passwort.</translation>
    </message>
    <message>
        <source>The broker %1 refuses the password, or the user %2.</source>
        <translation>Der Broker %1 weist das Passwort oder den Benutzer %2 ab.</translation>
    </message>
    <message>
        <source>The certificate of the broker %1 is not trusted: it was not issued by an authority of the CA file, or is out of date.</source>
        <translation>Dem Zertifikat des Brokers %1 wird nicht vertraut: Es stammt von keiner Stelle der CA-Datei oder ist abgelaufen.</translation>
    </message>
    <message>
        <source>The certificate of the broker %1 is for another name.</source>
        <translation>Das Zertifikat des Brokers %1 gilt für einen anderen Namen.</translation>
    </message>
    <message>
        <source>The broker %1 does not speak TLS as it should (%2).</source>
        <translation>Der Broker %1 spricht TLS nicht, wie er sollte (%2).</translation>
    </message>
    <message>
        <source>Nothing listens on %1: no broker runs there, or on another port.</source>
        <translation>Auf %1 hört niemand: Dort läuft kein Broker, oder er nutzt einen anderen Port.</translation>
    </message>
    <message>
        <source>No route to %1. Look at cable, switch and address.</source>
        <translation>Kein Weg zu %1. Kabel, Switch und Adresse prüfen.</translation>
    </message>
    <message>
        <source>%1 does not answer.</source>
        <translation>%1 antwortet nicht.</translation>
    </message>
    <message>
        <source>The connection to the broker %1 was lost (%2).</source>
        <translation>Die Verbindung zum Broker %1 ist abgerissen (%2).</translation>
    </message>
    <message>
        <source>There is no host called %1.</source>
        <translation>Es gibt keinen Rechner namens %1.</translation>
    </message>
    <message>
        <source>The CA file %1 cannot be read.</source>
        <translation>Die CA-Datei %1 ist nicht lesbar.</translation>
    </message>
    <message>
        <source>MQTT: off</source>
        <translation>MQTT: aus</translation>
    </message>
    <message>
        <source>The primary host %1 is not online; results wait for it.</source>
        <translation>Der Primary Host %1 ist nicht online; die Ergebnisse warten auf ihn.</translation>
    </message>
    <message>
        <source>%1 results were not sent: too many wait already. The library has them.</source>
        <translation>%1 Ergebnisse wurden nicht gesendet: Es warten schon zu viele. In der Bibliothek stehen sie.</translation>
    </message>
    <message>
        <source>Some results that waited for the broker could not be read again. The library has them.</source>
        <translation>Einige Ergebnisse, die auf den Broker warteten, waren nicht mehr lesbar. In der Bibliothek stehen sie.</translation>
    </message>
    <message>
        <source>MQTT: connected since %1, %2 waiting</source>
        <translation>MQTT: verbunden seit %1, %2 warten</translation>
    </message>
    <message>
        <source>MQTT: not connected since %1, %2 waiting</source>
        <translation>MQTT: nicht verbunden seit %1, %2 warten</translation>
    </message>
    <message>
        <source>it is not the program&apos;s own file</source>
        <translation>es ist nicht die Datei des Programms</translation>
    </message>
    <message>
        <source>one result is too long</source>
        <translation>ein Ergebnis ist zu lang</translation>
    </message>
    <message>
        <source>A result that waits for the broker</source>
        <translation>Ein Ergebnis, das auf den Broker wartet</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>es ist nicht lesbar</translation>
    </message>
    <message>
        <source>MQTT: not connected, %1 waiting</source>
        <translation>MQTT: nicht verbunden, %1 warten</translation>
    </message>
    <message>
        <source>read the ledgers of other stations</source>
        <translation>Journale anderer Stationen lesen</translation>
    </message>
    <message>
        <source>take the ledger of another station</source>
        <translation>das Journal einer anderen Station übernehmen</translation>
    </message>
    <message>
        <source>read the rows of other stations</source>
        <translation>Zeilen anderer Stationen lesen</translation>
    </message>
    <message>
        <source>take a row of another station</source>
        <translation>eine Zeile einer anderen Station übernehmen</translation>
    </message>
    <message>
        <source>merge another library</source>
        <translation>eine andere Bibliothek zusammenführen</translation>
    </message>
    <message>
        <source>note that it was seen</source>
        <translation>festhalten, dass es gesehen wurde</translation>
    </message>
    <message>
        <source>read the changes of all stations</source>
        <translation>Änderungen aller Stationen lesen</translation>
    </message>
    <message>
        <source>a link of its ledger cannot be read</source>
        <translation>ein Glied ihres Journals ist nicht lesbar</translation>
    </message>
    <message>
        <source>it is not as it was written: %1. Nothing was taken from it. Look at all of it with &quot;library verify&quot;, and merge a backup that is whole</source>
        <translation>sie ist nicht, wie sie geschrieben wurde: %1. Nichts wurde von ihr übernommen. Mit „library verify“ ganz ansehen und eine heile Sicherung zusammenführen</translation>
    </message>
    <message>
        <source>Nothing in %1 is new here.</source>
        <translation>Nichts in %1 ist hier neu.</translation>
    </message>
    <message>
        <source>%1 rows of %2 were taken, %3 were there already.</source>
        <translation>%1 Zeilen von %2 wurden übernommen, %3 waren schon da.</translation>
    </message>
    <message>
        <source>it is this library itself</source>
        <translation>es ist diese Bibliothek selbst</translation>
    </message>
    <message>
        <source>it is a copy of this library that was gone on with. Go on with one of them alone: keep the other aside, or put it back with &quot;library restore&quot;</source>
        <translation>es ist eine Kopie dieser Bibliothek, mit der weitergearbeitet wurde. Nur mit einer der beiden weiterarbeiten: die andere beiseitelegen oder mit „library restore“ zurückspielen</translation>
    </message>
    <message>
        <source>it has met a newer state of this library: an older copy was put back here. Put back the newest copy there is, then merge</source>
        <translation>sie kennt einen neueren Stand dieser Bibliothek: Hier wurde eine ältere Kopie zurückgespielt. Die neueste Kopie zurückspielen, dann zusammenführen</translation>
    </message>
    <message>
        <source>the two know the ledger of a library differently, by chain %1: one of them has met a copy of it that was gone on with. Find out which station works with a copy, and put back its newest library there</source>
        <translation>beide kennen das Journal einer Bibliothek verschieden, in der Kette %1: Eine von ihnen hat eine Kopie getroffen, mit der weitergearbeitet wurde. Herausfinden, welche Station mit einer Kopie arbeitet, und dort deren neueste Bibliothek zurückspielen</translation>
    </message>
    <message>
        <source>read how another station numbers</source>
        <translation>lesen, wie eine andere Station nummeriert</translation>
    </message>
    <message>
        <source>record the merge</source>
        <translation>das Zusammenführen festhalten</translation>
    </message>
    <message>
        <source>read its merges</source>
        <translation>lesen, was mit ihr zusammengeführt wurde</translation>
    </message>
    <message>
        <source>take the rows of another station</source>
        <translation>Zeilen einer anderen Station übernehmen</translation>
    </message>
    <message>
        <source>row %2 of %1 is not what its ledger says</source>
        <translation>Zeile %2 von %1 ist nicht, was ihr Journal sagt</translation>
    </message>
    <message>
        <source>read the recipes</source>
        <translation>Rezepte lesen</translation>
    </message>
    <message>
        <source>what stations have of each other</source>
        <translation>was Stationen voneinander haben</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>an %1</translation>
    </message>
    <message>
        <source>by %1 on %2</source>
        <translation>von %1 an %2</translation>
    </message>
    <message>
        <source>waiting for approval</source>
        <translation>wartet auf Freigabe</translation>
    </message>
    <message>
        <source>approved</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>retired</source>
        <translation>außer Gebrauch</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>aufgegeben</translation>
    </message>
    <message>
        <source>the recipe</source>
        <translation>das Rezept</translation>
    </message>
    <message>
        <source>&apos;%1&apos;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Stations renamed %1 while apart</source>
        <translation>Stationen haben %1 getrennt voneinander umbenannt</translation>
    </message>
    <message>
        <source>Stations decided apart whether %1 is recognised</source>
        <translation>Stationen haben getrennt entschieden, ob %1 erkannt wird</translation>
    </message>
    <message>
        <source>Stations changed the recipe of %1 while apart</source>
        <translation>Stationen haben das Rezept von %1 getrennt voneinander geändert</translation>
    </message>
    <message>
        <source>Stations gave %1 a code for scanners while apart</source>
        <translation>Stationen haben %1 getrennt voneinander einen Code für Scanner gegeben</translation>
    </message>
    <message>
        <source>Stations set tolerance limits of %1 while apart</source>
        <translation>Stationen haben Toleranzgrenzen von %1 getrennt voneinander gesetzt</translation>
    </message>
    <message>
        <source>Two types were called &apos;%1&apos;: the one %2 keeps the name, and the one %3 is now called &apos;%4&apos;. Rename or merge them where they are the same part.</source>
        <translation>Zwei Typen hießen „%1“: der %2 behält den Namen, der %3 heißt jetzt „%4“. Umbenennen oder zusammenführen, wo es dasselbe Teil ist.</translation>
    </message>
    <message>
        <source>Two types were given the code %1: the one %2 keeps it, and %3 has none now. Give it another.</source>
        <translation>Zwei Typen bekamen den Code %1: der %2 behält ihn, und %3 hat jetzt keinen. Einen anderen geben.</translation>
    </message>
    <message>
        <source>%1 was approved %2 while it was changed %3: it waits for approval again.</source>
        <translation>%1 wurde freigegeben %2, während es geändert wurde %3: Es wartet wieder auf Freigabe.</translation>
    </message>
    <message>
        <source>%1 was given up %2 while squeezes of it were kept elsewhere: it is retired. Put it back into use or merge it.</source>
        <translation>%1 wurde aufgegeben %2, während anderswo Druckversuche davon dazukamen: Der Typ ist außer Gebrauch. Wieder in Gebrauch nehmen oder zusammenführen.</translation>
    </message>
    <message>
        <source>%1: %2 (later) is in force; %3 is on record. Change it where that is wrong.</source>
        <translation>%1: %2 (später) gilt; %3 bleibt nachlesbar. Ändern, wo das falsch ist.</translation>
    </message>
    <message>
        <source>The library %1 was merged into this one.</source>
        <translation>Die Bibliothek %1 wurde mit dieser zusammengeführt.</translation>
    </message>
    <message>
        <source>holds %1 rows, of which the ledgers of other stations know %2</source>
        <translation>hat %1 Zeilen, von denen die Journale anderer Stationen %2 kennen</translation>
    </message>
    <message>
        <source>of another station is missing</source>
        <translation>einer anderen Station fehlt</translation>
    </message>
    <message>
        <source>is not as the other station wrote it</source>
        <translation>ist nicht, wie die andere Station es schrieb</translation>
    </message>
    <message>
        <source>does not say where the row was made, or under which number</source>
        <translation>sagt nicht, wo die Zeile entstand oder unter welcher Nummer</translation>
    </message>
    <message>
        <source>is missing or another than when it was merged</source>
        <translation>fehlt oder ist ein anderes als beim Zusammenführen</translation>
    </message>
    <message>
        <source>ends of its ledger</source>
        <translation>Enden der Journale</translation>
    </message>
    <message>
        <source>decided apart</source>
        <translation>getrennt entschieden</translation>
    </message>
    <message>
        <source>Library of another station merged</source>
        <translation>Bibliothek einer anderen Station zusammengeführt</translation>
    </message>
    <message>
        <source>Conflicts between stations seen</source>
        <translation>Konflikte zwischen Stationen gesehen</translation>
    </message>
    <message>
        <source>A library on a PostgreSQL server is copied by the server&apos;s own program, also while it is in use: %1</source>
        <translation>Eine Bibliothek auf einem PostgreSQL-Server kopiert dessen eigenes Programm, auch während sie benutzt wird: %1</translation>
    </message>
    <message>
        <source>A library on a PostgreSQL server is put back by the server&apos;s own program, from what pg_dump made, while no station has it open: %1</source>
        <translation>Eine Bibliothek auf einem PostgreSQL-Server spielt dessen eigenes Programm zurück, aus dem, was pg_dump gemacht hat, während keine Station sie offen hat: %1</translation>
    </message>
    <message>
        <source>write postgresql://USER@HOST:PORT/DATABASE</source>
        <translation>schreiben Sie postgresql://USER@HOST:PORT/DATABASE</translation>
    </message>
    <message>
        <source>a password does not belong in an address, which is shown, kept and logged: take it out and write the line HOST:PORT:DATABASE:USER:PASSWORD into the file .pgpass of your home folder, which only you may read</source>
        <translation>ein Passwort gehört nicht in eine Adresse, die angezeigt, aufbewahrt und protokolliert wird: nehmen Sie es heraus und schreiben Sie die Zeile HOST:PORT:DATABASE:USER:PASSWORD in die Datei .pgpass Ihres Home-Verzeichnisses, die nur Sie lesen dürfen</translation>
    </message>
    <message>
        <source>the value of %1 holds a sign that cannot be in it</source>
        <translation>im Wert von %1 steht ein Zeichen, das dort nicht stehen kann</translation>
    </message>
    <message>
        <source>it has no option %1; there are %2</source>
        <translation>eine Option %1 hat sie nicht; es gibt %2</translation>
    </message>
    <message>
        <source>the address cannot be read; %1</source>
        <translation>die Adresse ist nicht zu lesen; %1</translation>
    </message>
    <message>
        <source>a port is a number from 1 to 65535</source>
        <translation>ein Port ist eine Zahl von 1 bis 65535</translation>
    </message>
    <message>
        <source>it names no database; %1</source>
        <translation>sie nennt keine Datenbank; %1</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>its database has the encoding %1, which does not hold every sign; make it with createdb --encoding=UTF8 --template=template0</source>
        <translation>ihre Datenbank hat die Kodierung %1, in die nicht jedes Zeichen passt; legen Sie sie mit createdb --encoding=UTF8 --template=template0 an</translation>
    </message>
    <message>
        <source>the server is PostgreSQL %1; it has to be 13 or newer</source>
        <translation>der Server ist PostgreSQL %1; es muss 13 oder neuer sein</translation>
    </message>
    <message>
        <source>the user has no schema to work in; let who looks after the server grant the rights to the schema public</source>
        <translation>der Benutzer hat kein Schema, in dem er arbeiten darf; lassen Sie sich vom Verwalter des Servers Rechte am Schema public geben</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>fortfahren</translation>
    </message>
    <message>
        <source>the server ended the connection on the way</source>
        <translation>der Server hat unterwegs die Verbindung beendet</translation>
    </message>
    <message>
        <source>the server ended the connection; what is asked for next connects again</source>
        <translation>der Server hat die Verbindung beendet; der nächste Auftrag verbindet neu</translation>
    </message>
    <message>
        <source>the server took too long and was stopped; try again when it has less to do</source>
        <translation>der Server brauchte zu lange und wurde abgebrochen; versuchen Sie es noch einmal, wenn er weniger zu tun hat</translation>
    </message>
    <message>
        <source>the server&apos;s disk is full; who looks after it has to make room</source>
        <translation>der Datenträger des Servers ist voll; sein Verwalter muss Platz schaffen</translation>
    </message>
    <message>
        <source>the server has no connection left; end other programs, or let max_connections be raised</source>
        <translation>der Server hat keine Verbindung mehr frei; beenden Sie andere Programme, oder lassen Sie max_connections erhöhen</translation>
    </message>
    <message>
        <source>the server does not permit it (%1); let who looks after it grant the rights, or make this user the owner of the database</source>
        <translation>der Server erlaubt es nicht (%1); lassen Sie sich von seinem Verwalter die Rechte geben oder diesen Benutzer zum Eigentümer der Datenbank machen</translation>
    </message>
    <message>
        <source>the server may only be read from, as a copy that follows another; name the one that is written to</source>
        <translation>von diesem Server darf nur gelesen werden, wie von einer Kopie, die einem anderen folgt; nennen Sie den, auf den geschrieben wird</translation>
    </message>
    <message>
        <source>the server asks for the password of user %1, and none was found: write the line HOST:PORT:DATABASE:USER:PASSWORD into the file .pgpass of your home folder, which only you may read (chmod 600)</source>
        <translation>der Server fragt nach dem Passwort des Benutzers %1, und es wurde keines gefunden: schreiben Sie die Zeile HOST:PORT:DATABASE:USER:PASSWORD in die Datei .pgpass Ihres Home-Verzeichnisses, die nur Sie lesen dürfen (chmod 600)</translation>
    </message>
    <message>
        <source>the server refuses the password of user %1: look at the file .pgpass of your home folder</source>
        <translation>der Server weist das Passwort des Benutzers %1 ab: sehen Sie in die Datei .pgpass Ihres Home-Verzeichnisses</translation>
    </message>
    <message>
        <source>the server does not let user %1 in from this computer, or not without encryption: its pg_hba.conf has no line for it</source>
        <translation>der Server lässt den Benutzer %1 von diesem Rechner nicht ein, oder nicht ohne Verschlüsselung: in seiner pg_hba.conf fehlt die Zeile dafür</translation>
    </message>
    <message>
        <source>the server at %1 knows no user %2: let who looks after it make one (createuser)</source>
        <translation>der Server auf %1 kennt keinen Benutzer %2: lassen Sie ihn vom Verwalter anlegen (createuser)</translation>
    </message>
    <message>
        <source>there is no database %1 on %2: let who looks after it make one (createdb)</source>
        <translation>auf %2 gibt es keine Datenbank %1: lassen Sie sie vom Verwalter anlegen (createdb)</translation>
    </message>
    <message>
        <source>no safe connection with %1 came about (%2): look at sslmode and sslrootcert</source>
        <translation>mit %1 kam keine sichere Verbindung zustande (%2): prüfen Sie sslmode und sslrootcert</translation>
    </message>
    <message>
        <source>no server answers at %1: see that it runs, and that name, port and network are right (%2)</source>
        <translation>auf %1 antwortet kein Server: sehen Sie nach, ob er läuft und ob Name, Port und Netz stimmen (%2)</translation>
    </message>
    <message>
        <source>the server at %1 says: %2</source>
        <translation>der Server auf %1 meldet: %2</translation>
    </message>
    <message>
        <source>a text in it holds the sign NUL, which the server cannot store</source>
        <translation>ein Text darin enthält das Zeichen NUL, das der Server nicht speichern kann</translation>
    </message>
    <message>
        <source>a step of it failed on the server</source>
        <translation>ein Schritt davon ist auf dem Server gescheitert</translation>
    </message>
    <message>
        <source>it has taken types from another server&apos;s library than %1, which it would have to be brought in step with</source>
        <translation>sie hat Typen aus der Bibliothek eines anderen Servers als %1 übernommen und müsste mit jenem abgeglichen werden</translation>
    </message>
    <message>
        <source>be brought to the server</source>
        <translation>zum Server gebracht werden</translation>
    </message>
    <message>
        <source>read the types of the server</source>
        <translation>die Typen des Servers lesen</translation>
    </message>
    <message>
        <source>it is there already</source>
        <translation>es ist schon da</translation>
    </message>
    <message>
        <source>take what a station has written</source>
        <translation>übernehmen, was eine Station geschrieben hat</translation>
    </message>
    <message>
        <source>take the types of the server</source>
        <translation>die Typen des Servers übernehmen</translation>
    </message>
    <message>
        <source>it is kept in step with a server, which has all that is in it: bring the other library to the same server with &quot;library sync&quot;</source>
        <translation>sie wird mit einem Server abgeglichen, der alles hat, was in ihr ist: die andere Bibliothek mit „library sync“ zum selben Server bringen</translation>
    </message>
    <message>
        <source>libraries are merged file into file; a station is kept in step with a library on a server with &quot;library sync&quot;</source>
        <translation>Bibliotheken werden von Datei zu Datei zusammengeführt; mit einer auf einem Server wird eine Station mit „library sync“ abgeglichen</translation>
    </message>
    <message>
        <source>a change that %1 has from here is no longer here: an older copy was put back. Put back the newest copy there is</source>
        <translation>eine Änderung, die %1 von hier hat, ist nicht mehr hier: Eine ältere Kopie wurde zurückgespielt. Die neueste Kopie zurückspielen, die es gibt</translation>
    </message>
    <message>
        <source>compare the units of its types</source>
        <translation>die Einheiten ihrer Typen vergleichen</translation>
    </message>
    <message>
        <source>note how far the server is</source>
        <translation>vermerken, wie weit der Server ist</translation>
    </message>
    <message>
        <source>The plant&apos;s library is on a server: postgresql://USER@HOST:PORT/NAME, not &quot;%1&quot;.</source>
        <translation>Die Bibliothek des Werks ist auf einem Server: postgresql://USER@HOST:PORT/NAME, nicht „%1“.</translation>
    </message>
    <message>
        <source>This station&apos;s library is on a server already. Only a file is kept in step with a server.</source>
        <translation>Die Bibliothek dieser Station ist schon auf einem Server. Nur eine Datei wird mit einem Server abgeglichen.</translation>
    </message>
    <message>
        <source>The server has not answered for %1 s.</source>
        <translation>Der Server antwortet seit %1 s nicht.</translation>
    </message>
    <message>
        <source>it is needed alone at this moment</source>
        <translation>sie wird in diesem Augenblick allein gebraucht</translation>
    </message>
    <message>
        <source>1 result waiting</source>
        <translation>1 Ergebnis wartet</translation>
    </message>
    <message>
        <source>%1 results waiting</source>
        <translation>%1 Ergebnisse warten</translation>
    </message>
    <message>
        <source>plant: in step</source>
        <translation>Werk: abgeglichen</translation>
    </message>
    <message>
        <source>plant: %1</source>
        <translation>Werk: %1</translation>
    </message>
    <message>
        <source>plant: not in step</source>
        <translation>Werk: nicht abgeglichen</translation>
    </message>
    <message>
        <source>plant: being brought in step</source>
        <translation>Werk: wird abgeglichen</translation>
    </message>
    <message>
        <source>plant: server not reached yet</source>
        <translation>Werk: Server noch nicht erreicht</translation>
    </message>
    <message>
        <source>plant: connecting</source>
        <translation>Werk: verbindet</translation>
    </message>
    <message>
        <source>plant: server not reached since %1</source>
        <translation>Werk: Server nicht erreicht seit %1</translation>
    </message>
    <message>
        <source>plant: %1, server not reached since %2</source>
        <translation>Werk: %1, Server nicht erreicht seit %2</translation>
    </message>
    <message>
        <source>plant: off</source>
        <translation>Werk: aus</translation>
    </message>
    <message>
        <source>More that stations decided apart: gripscope-cli library status tells all of it.</source>
        <translation>Mehr, was Stationen getrennt entschieden haben: gripscope-cli library status sagt alles davon.</translation>
    </message>
    <message>
        <source>The clock of this computer is %1 s off: results have wrong times. chronyc makestep sets it.</source>
        <translation>Die Uhr dieses Rechners geht um %1 s falsch: Ergebnisse haben falsche Zeiten. chronyc makestep stellt sie.</translation>
    </message>
    <message>
        <source>what the changes of a plant are found by</source>
        <translation>wonach die Änderungen eines Werks gefunden werden</translation>
    </message>
    <message>
        <source>%1 (plant)</source>
        <translation>%1 (Werk)</translation>
    </message>
    <message>
        <source>%1 (plant, %2)</source>
        <translation>%1 (Werk, %2)</translation>
    </message>
    <message>
        <source>Person as at the plant</source>
        <translation>Person wie im Werk</translation>
    </message>
    <message>
        <source>Qt&apos;s PostgreSQL driver is not installed; on Debian: apt install %1</source>
        <translation>Qts PostgreSQL-Treiber ist nicht installiert; unter Debian: apt install %1</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for %1 is missing</source>
        <translation>Qts Treiber für %1 fehlt</translation>
    </message>
    <message>
        <source>Type this in a terminal: sudo apt install %1</source>
        <translation>In einem Terminal eingeben: sudo apt install %1</translation>
    </message>
    <message>
        <source>may sign in</source>
        <translation>darf sich anmelden</translation>
    </message>
    <message>
        <source>name at the plant</source>
        <translation>Name im Werk</translation>
    </message>
</context>
<context>
    <name>Yield</name>
    <message>
        <source>%1 as expected (%2 to %3)</source>
        <translation>%1 wie erwartet (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 of %2 parts that were judged were as expected. In brackets: where the rate itself lies with 95 % confidence (exact bounds). Squeezes that were not valid or inconclusive judged nothing, and are left out.</source>
        <translation>%1 von %2 beurteilten Teilen waren wie erwartet. In Klammern: wo die Rate selbst mit 95 % Vertrauen liegt (exakte Grenzen). Ungültige oder unentschiedene Druckversuche haben nichts beurteilt und zählen nicht mit.</translation>
    </message>
    <message>
        <source>%1 of a known type (%2 to %3)</source>
        <translation>%1 eines bekannten Typs (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 as expected or of a known type (%2 to %3)</source>
        <translation>%1 wie erwartet oder eines bekannten Typs (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 of %2 were as expected</source>
        <translation>%1 von %2 waren wie erwartet</translation>
    </message>
    <message>
        <source>%1 of %2 were of the expected type, or of a known one where none was expected</source>
        <translation>%1 von %2 waren vom erwarteten Typ oder, wo keiner erwartet war, von einem bekannten</translation>
    </message>
    <message>
        <source>%1 of %2 parts that were judged were of the expected type, or of a known one where none was expected. In brackets: where the rate itself lies with 95 % confidence (exact bounds). Squeezes that were not valid or inconclusive judged nothing, and are left out.</source>
        <translation>%1 von %2 beurteilten Teilen waren vom erwarteten Typ oder, wo keiner erwartet war, von einem bekannten. In Klammern: wo die Rate selbst mit 95 % Vertrauen liegt (exakte Grenzen). Ungültige oder unentschiedene Druckversuche haben nichts beurteilt und bleiben außen vor.</translation>
    </message>
</context>
<context>
    <name>gripscope::AboutDialog</name>
    <message>
        <source>About Gripscope</source>
        <translation>Über Gripscope</translation>
    </message>
    <message>
        <source>Gripscope %1</source>
        <translation>Gripscope %1</translation>
    </message>
    <message>
        <source>Squeezes a part for about a second and says which mass, damping and stiffness it showed, with honest error bars, and which enrolled type it is, or that it is none of them, or that the measurement was not good enough. Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Drückt ein Teil etwa eine Sekunde lang und sagt, welche Masse, Dämpfung und Steifigkeit es gezeigt hat, mit ehrlichen Fehlerbalken, und welcher eingelernte Typ es ist, oder dass es keiner davon ist, oder dass die Messung nicht gut genug war. Freie Software unter der GNU General Public License, Version 3 oder später.</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Stop the gripper and disarm it, on every page</source>
        <translation>Greifer anhalten und entschärfen, auf jeder Seite</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Squeeze (pages Inspect and Enroll)</source>
        <translation>Drücken (Seiten Prüfen und Einlernen)</translation>
    </message>
    <message>
        <source>Ctrl+%1</source>
        <translation>Strg+%1</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Strg+,</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>Inspect the gripper: reports, counters, self-test</source>
        <translation>Den Greifer untersuchen: Reports, Zähler, Selbsttest</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The manual, at the page about this screen</source>
        <translation>Das Handbuch, auf der Seite zu diesem Bild</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Strg+Umschalt+A</translation>
    </message>
    <message>
        <source>Arm the gripper: hold the keys for a second</source>
        <translation>Greifer scharf schalten: die Tasten eine Sekunde lang halten</translation>
    </message>
</context>
<context>
    <name>gripscope::AccessDialog</name>
    <message>
        <source>Allow access to the gripper</source>
        <translation>Zugriff auf den Greifer erlauben</translation>
    </message>
    <message>
        <source>This user may not open %1</source>
        <translation>Dieser Benutzer darf %1 nicht öffnen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>What is missing is %1.</source>
        <translation>Es fehlt: %1.</translation>
    </message>
    <message>
        <source>Type this line in a terminal. It asks for the password of an administrator. Gripscope then connects the gripper by itself.</source>
        <translation>Diese Zeile in ein Terminal eingeben. Sie fragt nach dem Passwort eines Administrators. Danach verbindet Gripscope den Greifer von selbst.</translation>
    </message>
    <message>
        <source>Line to type</source>
        <translation>Einzugebende Zeile</translation>
    </message>
</context>
<context>
    <name>gripscope::AdvicePanel</name>
    <message>
        <source>How many clusters are there?</source>
        <translation>Wie viele Cluster gibt es?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Compares 1 to 8 clusters by five criteria</source>
        <translation>Vergleicht 1 bis 8 Cluster nach fünf Kriterien</translation>
    </message>
    <message>
        <source>Advice on the number of clusters</source>
        <translation>Empfehlung zur Anzahl der Cluster</translation>
    </message>
    <message>
        <source>Criteria for the number of clusters</source>
        <translation>Kriterien für die Anzahl der Cluster</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 nehmen</translation>
    </message>
</context>
<context>
    <name>gripscope::AdviceTableModel</name>
    <message>
        <source>The best by this criterion</source>
        <translation>Das Beste nach diesem Kriterium</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Number of clusters</source>
        <translation>Anzahl der Cluster</translation>
    </message>
    <message>
        <source>Silh.</source>
        <translation>Silh.</translation>
    </message>
    <message>
        <source>Silhouette: how much nearer a squeeze is to its own cluster than to the next. High is good.</source>
        <translation>Silhouette: wie viel näher ein Druckversuch seinem eigenen Cluster ist als dem nächsten. Hoch ist gut.</translation>
    </message>
    <message>
        <source>C-H</source>
        <translation>C-H</translation>
    </message>
    <message>
        <source>Calinski-Harabasz: variance between the clusters over that within. High is good.</source>
        <translation>Calinski-Harabasz: Varianz zwischen den Clustern zu der innerhalb. Hoch ist gut.</translation>
    </message>
    <message>
        <source>D-B</source>
        <translation>D-B</translation>
    </message>
    <message>
        <source>Davies-Bouldin: the worst overlap of each cluster with another, on average. Low is good.</source>
        <translation>Davies-Bouldin: die schlimmste Überlappung jedes Clusters mit einem anderen, im Mittel. Niedrig ist gut.</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Gap</translation>
    </message>
    <message>
        <source>Gap: how much tighter the clusters are than those of squeezes spread evenly. Its best is the smallest within an error of the first maximum.</source>
        <translation>Gap: wie viel enger die Cluster sind als die gleichmäßig verteilter Druckversuche. Am besten ist das kleinste K innerhalb eines Fehlers vom ersten Maximum.</translation>
    </message>
    <message>
        <source>BIC</source>
        <translation>BIC</translation>
    </message>
    <message>
        <source>Bayesian information criterion of Gaussian mixtures, the better of tied and full. Low is good.</source>
        <translation>Bayes&apos;sches Informationskriterium von Gauß-Mischungen, das bessere von gemeinsam und frei. Niedrig ist gut.</translation>
    </message>
</context>
<context>
    <name>gripscope::Attendance</name>
    <message>
        <source>Disarmed: the station was locked.</source>
        <translation>Entschärft: Die Station wurde gesperrt.</translation>
    </message>
    <message>
        <source>Disarmed: the station went to sleep.</source>
        <translation>Entschärft: Der Rechner ging in den Ruhezustand.</translation>
    </message>
    <message>
        <source>Disarmed: another user took the station over.</source>
        <translation>Entschärft: Ein anderer Benutzer hat die Station übernommen.</translation>
    </message>
    <message>
        <source>Disarmed: nothing was done for %1 min.</source>
        <translation>Entschärft: %1 min lang wurde nichts getan.</translation>
    </message>
    <message>
        <source>Disarmed: the person who worked here has signed out.</source>
        <translation>Entschärft: Wer hier gearbeitet hat, hat sich abgemeldet.</translation>
    </message>
</context>
<context>
    <name>gripscope::AuditDialog</name>
    <message>
        <source>Verify</source>
        <translation>Nachprüfen</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Änderungsprotokoll</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Filter by person, type, reason or station</source>
        <translation>Nach Person, Typ, Grund oder Station filtern</translation>
    </message>
    <message>
        <source>Filter text</source>
        <translation>Filtertext</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Signing in and out</source>
        <translation>An- und Abmeldungen</translation>
    </message>
    <message>
        <source>Authorisations</source>
        <translation>Genehmigungen</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Fehlerraten</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>Kalibrierungen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Entries: %1</source>
        <translation>Einträge: %1</translation>
    </message>
    <message>
        <source>Nothing yet: changes of types, rates and calibrations, and who signs in, will be here.</source>
        <translation>Noch nichts: Hier stehen Änderungen an Typen, Fehlerraten und Kalibrierungen, und wer sich anmeldet.</translation>
    </message>
    <message>
        <source>Nothing matches the filters.</source>
        <translation>Nichts passt zu den Filtern.</translation>
    </message>
    <message>
        <source>Export the audit trail</source>
        <translation>Änderungsprotokoll exportieren</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Audit trail written to %1</source>
        <translation>Änderungsprotokoll geschrieben: %1</translation>
    </message>
    <message>
        <source>Arming</source>
        <translation>Scharfschalten</translation>
    </message>
    <message>
        <source>Read all of the library and check that no row was changed, removed or put in past the program</source>
        <translation>Die ganze Bibliothek lesen und prüfen, dass keine Zeile am Programm vorbei geändert, entfernt oder eingefügt wurde</translation>
    </message>
    <message>
        <source>Reading all of the library…</source>
        <translation>Die ganze Bibliothek wird gelesen…</translation>
    </message>
    <message>
        <source>Inspections</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Batches</source>
        <translation>Lose</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exporte</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
</context>
<context>
    <name>gripscope::AuditModel</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>To what</source>
        <translation>Woran</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
</context>
<context>
    <name>gripscope::AuthorizeWords</name>
    <message>
        <source>Why? The reason is kept with the change.</source>
        <translation>Warum? Der Grund wird mit der Änderung aufbewahrt.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Change these settings</source>
        <translation>Diese Einstellungen ändern</translation>
    </message>
    <message>
        <source>Change the rates</source>
        <translation>Fehlerraten ändern</translation>
    </message>
</context>
<context>
    <name>gripscope::AxisScale</name>
    <message>
        <source>%1 (as printed)</source>
        <translation>%1 (wie gedruckt)</translation>
    </message>
</context>
<context>
    <name>gripscope::BatchDialog</name>
    <message>
        <source>Begin the batch</source>
        <translation>Los beginnen</translation>
    </message>
    <message>
        <source>Begin a batch</source>
        <translation>Ein Los beginnen</translation>
    </message>
    <message>
        <source>Name or number of the batch</source>
        <translation>Name oder Nummer des Loses</translation>
    </message>
    <message>
        <source>Parts wanted</source>
        <translation>Gewünschte Teile</translation>
    </message>
    <message>
        <source>Each part that is one of the enrolled types counts, since no type is expected. Other parts and measurements that are not valid do not count. The batch ends by itself.</source>
        <translation>Jedes Teil eines eingelernten Typs zählt, da kein Typ erwartet wird. Andere Teile und ungültige Messungen zählen nicht. Das Los endet von selbst.</translation>
    </message>
    <message>
        <source>Parts that are %1 count. Other parts and measurements that are not valid do not count. The batch ends by itself.</source>
        <translation>Teile vom Typ %1 zählen. Andere Teile und ungültige Messungen zählen nicht. Das Los endet von selbst.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Name or number</source>
        <translation>Name oder Nummer</translation>
    </message>
    <message>
        <source>Parts wanted, as expected</source>
        <translation>Gewünschte Teile, wie erwartet</translation>
    </message>
    <message>
        <source>Parts wanted, of a known type</source>
        <translation>Gewünschte Teile, eines bekannten Typs</translation>
    </message>
</context>
<context>
    <name>gripscope::BodePlots</name>
    <message>
        <source>Bode plot</source>
        <translation>Bode-Diagramm</translation>
    </message>
    <message>
        <source>Phase (°)</source>
        <translation>Phase (°)</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>f (Hz)</source>
        <translation>f (Hz)</translation>
    </message>
    <message>
        <source>Magnitude (as recorded)</source>
        <translation>Amplitude (wie aufgezeichnet)</translation>
    </message>
    <message>
        <source>Magnitude (%1)</source>
        <translation>Amplitude (%1)</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>too few samples in a row for a measured one: %1 are needed</source>
        <translation>zu wenige Abtastwerte am Stück für einen gemessenen Verlauf: %1 sind nötig</translation>
    </message>
    <message>
        <source>the force does not change</source>
        <translation>die Kraft ändert sich nicht</translation>
    </message>
    <message>
        <source>below %1 pale, not reliable</source>
        <translation>unter %1 blass, nicht verlässlich</translation>
    </message>
    <message numerus="yes">
        <source>%n measured frequencies, %1 of them pale for a low coherence</source>
        <translation>
            <numerusform>%n gemessene Frequenz, davon %1 blass wegen kleiner Kohärenz</numerusform>
            <numerusform>%n gemessene Frequenzen, davon %1 blass wegen kleiner Kohärenz</numerusform>
        </translation>
    </message>
    <message>
        <source>measured, 95 %</source>
        <translation>gemessen, 95 %</translation>
    </message>
    <message>
        <source>coherence too low</source>
        <translation>Kohärenz zu klein</translation>
    </message>
    <message>
        <source>model, %1, 95 %</source>
        <translation>Modell, %1, 95 %</translation>
    </message>
</context>
<context>
    <name>gripscope::BudgetPanel</name>
    <message>
        <source>Uncertainty budget</source>
        <translation>Unsicherheitsbudget</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>gripscope::BudgetTableModel</name>
    <message>
        <source>Combined</source>
        <translation>Kombiniert</translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>Expanded</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>half of the %1 % interval</source>
        <translation>halbes %1-%-Intervall</translation>
    </message>
    <message>
        <source>Standard uncertainty; the bar is the effect&apos;s share of the variance</source>
        <translation>Standardunsicherheit; der Balken ist der Anteil des Einflusses an der Varianz</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Einfluss</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>Rauschen Weg</translation>
    </message>
    <message>
        <source>Force noise</source>
        <translation>Rauschen Kraft</translation>
    </message>
    <message>
        <source>Lag of the channels</source>
        <translation>Zeitversatz</translation>
    </message>
    <message>
        <source>Force between samples</source>
        <translation>Kraftverlauf</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Give of the frame</source>
        <translation>Nachgiebigkeit</translation>
    </message>
    <message>
        <source>Empty gripper</source>
        <translation>Leerer Greifer</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Steps of the position</source>
        <translation>Stufen des Wegs</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Times of the samples</source>
        <translation>Zeiten der Abtastwerte</translation>
    </message>
</context>
<context>
    <name>gripscope::ByteTableModel</name>
    <message>
        <source>Byte %1, %2</source>
        <translation>Byte %1, %2</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>rests</source>
        <translation>ruht</translation>
    </message>
    <message>
        <source>Byte</source>
        <translation>Byte</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Min.</translation>
    </message>
    <message>
        <source>Most</source>
        <translation>Max.</translation>
    </message>
    <message>
        <source>per s</source>
        <translation>je s</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>Gehört zu</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrateCheck</name>
    <message>
        <source>Check on a reference spring</source>
        <translation>Kontrolle an einer Referenzfeder</translation>
    </message>
    <message>
        <source>Check now (Space)</source>
        <translation>Kontrollieren (Leertaste)</translation>
    </message>
    <message>
        <source>Check again (Space)</source>
        <translation>Erneut (Leertaste)</translation>
    </message>
    <message>
        <source>State first what the gripper is to be checked on: a spring whose stiffness is known better than you need it.</source>
        <translation>Zuerst angeben, woran der Greifer zu kontrollieren ist: eine Feder, deren Steifigkeit besser bekannt ist als nötig.</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontrollen</translation>
    </message>
    <message>
        <source>None yet. Grip the spring, arm, and check: the errors found are kept here, so that a drift shows before it matters.</source>
        <translation>Noch keine. Die Feder greifen, scharf schalten und kontrollieren: Die gefundenen Fehler bleiben hier, sodass sich eine Drift zeigt, bevor sie schadet.</translation>
    </message>
    <message>
        <source>Change it…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>State the spring…</source>
        <translation>Feder angeben…</translation>
    </message>
    <message>
        <source>Use this object</source>
        <translation>Dieses Objekt nehmen</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrateGripper</name>
    <message>
        <source>What a gripper is characterised by, one after the other</source>
        <translation>Was einen Greifer kennzeichnet, eins nach dem anderen</translation>
    </message>
    <message>
        <source>1  Empty gripper</source>
        <translation>1  Leerer Greifer</translation>
    </message>
    <message>
        <source>2  Frame</source>
        <translation>2  Gestell</translation>
    </message>
    <message>
        <source>3  Lag</source>
        <translation>3  Zeitversatz</translation>
    </message>
    <message>
        <source>Next: the frame</source>
        <translation>Weiter: das Gestell</translation>
    </message>
    <message>
        <source>Next: the lag</source>
        <translation>Weiter: der Zeitversatz</translation>
    </message>
    <message>
        <source>Known of this gripper</source>
        <translation>Bekannt von diesem Greifer</translation>
    </message>
    <message>
        <source>Take nothing off any more</source>
        <translation>Nichts mehr abziehen</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>stated by the gripper</source>
        <translation>Angabe des Greifers</translation>
    </message>
    <message>
        <source>Nothing is taken off. The m, b and k of a part include those of the fingers, in enrolled types and in inspections alike, so that they still compare on this gripper.</source>
        <translation>Nichts wird abgezogen. m, b und k eines Teils enthalten die der Finger, in eingelernten Typen wie in Prüfungen, sodass sie sich an diesem Greifer trotzdem vergleichen lassen.</translation>
    </message>
    <message>
        <source>The empty gripper is taken off every later squeeze, and its uncertainty goes into the error bars. Types that were enrolled without this include the fingers: enroll them again. Measure anew when the fingers are changed.</source>
        <translation>Der leere Greifer wird von jedem späteren Druckversuch abgezogen, und seine Unsicherheit geht in die Fehlerbalken ein. Ohne das eingelernte Typen enthalten die Finger: neu einlernen. Nach einem Wechsel der Finger neu messen.</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibratePage</name>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Parts of this page</source>
        <translation>Teile dieser Seite</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Spring check</source>
        <translation>Federkontrolle</translation>
    </message>
    <message>
        <source>This gripper</source>
        <translation>Dieser Greifer</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrateSensors</name>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>None yet. Choose a channel and its loads on the left, put on one after the other, and look at what is left beside the curve before you accept it.</source>
        <translation>Noch keine. Links Kanal und Lasten wählen, eine nach der anderen auflegen und vor dem Annehmen ansehen, was neben der Kurve übrig bleibt.</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>Kalibrierungen</translation>
    </message>
    <message>
        <source>Certificate…</source>
        <translation>Zertifikat…</translation>
    </message>
    <message>
        <source>Gripper %1, by %2</source>
        <translation>Greifer %1, von %2</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>Zertifikat speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Certificate written to %1</source>
        <translation>Zertifikat nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrateSetup</name>
    <message>
        <source>and down</source>
        <translation>und ab</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Position, with gauge blocks</source>
        <translation>Weg, mit Endmaßen</translation>
    </message>
    <message>
        <source>for instance Weights M1, set 4711</source>
        <translation>zum Beispiel Gewichte M1, Satz 4711</translation>
    </message>
    <message>
        <source>number, if it has one</source>
        <translation>falls vorhanden</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Degree of the curve</source>
        <translation>Grad der Kurve</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Its certificate</source>
        <translation>Ihr Zertifikat</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>No gripper is connected. Choose one at the top.</source>
        <translation>Kein Greifer ist verbunden. Oben einen wählen.</translation>
    </message>
    <message>
        <source>This gripper has no serial number to keep its calibration under.</source>
        <translation>Dieser Greifer hat keine Seriennummer, unter der seine Kalibrierung abzulegen wäre.</translation>
    </message>
    <message>
        <source>The gripper is armed, and hands will be near: disarm it first.</source>
        <translation>Der Greifer ist scharf, und gleich wird an ihm gearbeitet: erst entschärfen.</translation>
    </message>
    <message>
        <source>Loads are numbers with commas between, such as 0, 10, 20.</source>
        <translation>Lasten sind Zahlen mit Komma und Leerzeichen dazwischen, etwa 0, 10, 20.</translation>
    </message>
    <message>
        <source>Say what the loads are realised with: it stands on the certificate.</source>
        <translation>Angeben, womit die Lasten dargestellt werden: Es steht auf dem Zertifikat.</translation>
    </message>
    <message>
        <source>%1 points, about a second each. The gripper does not move.</source>
        <translation>%1 Punkte, je etwa eine Sekunde. Der Greifer bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Force, with reference weights</source>
        <translation>Kraft, mit Gewichten</translation>
    </message>
    <message>
        <source>Force, with a load cell</source>
        <translation>Kraft, mit einer Kraftmessdose</translation>
    </message>
    <message>
        <source>In %1, the least first</source>
        <translation>In %1, die kleinste zuerst</translation>
    </message>
    <message>
        <source>Loads (%1)</source>
        <translation>Lasten (%1)</translation>
    </message>
    <message>
        <source>Force, with masses in kilograms</source>
        <translation>Kraft, mit Massen in Kilogramm</translation>
    </message>
    <message>
        <source>Force, with masses in pounds</source>
        <translation>Kraft, mit Massen in Pfund</translation>
    </message>
    <message>
        <source>For the certificate…</source>
        <translation>Für das Zertifikat…</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrateTaking</name>
    <message>
        <source>Leave it</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Reading the channel</source>
        <translation>Der Kanal wird gelesen</translation>
    </message>
    <message>
        <source>Take it (Space)</source>
        <translation>Aufnehmen (Leertaste)</translation>
    </message>
    <message>
        <source>The channel says</source>
        <translation>Der Kanal zeigt</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Degree of the curve</source>
        <translation>Grad der Kurve</translation>
    </message>
    <message>
        <source>Holds until</source>
        <translation>Gilt bis</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Point %1 of %2</source>
        <translation>Punkt %1 von %2</translation>
    </message>
    <message>
        <source>No curve</source>
        <translation>Keine Kurve</translation>
    </message>
    <message>
        <source>Undo the last (Backspace)</source>
        <translation>Letzten Punkt zurück (Rücktaste)</translation>
    </message>
    <message>
        <source>The load cell shows</source>
        <translation>Die Messdose zeigt</translation>
    </message>
    <message>
        <source>Coming from less: set the fingers on this block, and let them rest.</source>
        <translation>Von weniger kommend: die Finger auf dieses Endmaß setzen und ruhen lassen.</translation>
    </message>
    <message>
        <source>Coming from more: set the fingers on this block, and let them rest.</source>
        <translation>Von mehr kommend: die Finger auf dieses Endmaß setzen und ruhen lassen.</translation>
    </message>
    <message>
        <source>Take everything off, and let it rest.</source>
        <translation>Alles abnehmen und ruhen lassen.</translation>
    </message>
    <message>
        <source>Press up to about this, not beyond, hold it, and type what the cell shows.</source>
        <translation>Bis etwa hierher drücken, nicht darüber, halten und eingeben, was die Messdose zeigt.</translation>
    </message>
    <message>
        <source>Give way down to about this, hold it, and type what the cell shows.</source>
        <translation>Bis etwa hierher nachgeben, halten und eingeben, was die Messdose zeigt.</translation>
    </message>
    <message>
        <source>Add weights up to this, never beyond, and let them rest.</source>
        <translation>Gewichte bis hierher auflegen, nie darüber, und ruhen lassen.</translation>
    </message>
    <message>
        <source>Take weights off down to this, never below, and let them rest.</source>
        <translation>Gewichte bis hierher abnehmen, nie darunter, und ruhen lassen.</translation>
    </message>
    <message>
        <source>● rests: it can be taken</source>
        <translation>● ruht: kann aufgenommen werden</translation>
    </message>
    <message>
        <source>◌ still moves: wait</source>
        <translation>◌ bewegt sich noch: warten</translation>
    </message>
    <message>
        <source>◌ not enough samples yet</source>
        <translation>◌ noch zu wenige Abtastwerte</translation>
    </message>
    <message>
        <source>Accept the calibration</source>
        <translation>Kalibrierung übernehmen</translation>
    </message>
    <message>
        <source>Check afterwards: point %1 of %2</source>
        <translation>Kontrolle danach: Punkt %1 von %2</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrationCertificate</name>
    <message>
        <source>of the load</source>
        <translation>der Last</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Its certificate</source>
        <translation>Ihr Zertifikat</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Holds until</source>
        <translation>Gilt bis</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Load (%1)</source>
        <translation>Last (%1)</translation>
    </message>
    <message>
        <source>Reading (%1)</source>
        <translation>Anzeige (%1)</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Kalibrierzertifikat</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Gripscope %1, record %2</source>
        <translation>Gripscope %1, Eintrag %2</translation>
    </message>
    <message>
        <source>none: it was stored before certificates had numbers</source>
        <translation>keine: gespeichert, bevor Zertifikate Nummern hatten</translation>
    </message>
    <message>
        <source>%1, valid until %2</source>
        <translation>%1, gültig bis %2</translation>
    </message>
    <message>
        <source>Ambient temperature</source>
        <translation>Umgebungstemperatur</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>masses in %1, taken for forces by the local gravity of %2 m/s²</source>
        <translation>Massen in %1, mit der örtlichen Fallbeschleunigung von %2 m/s² als Kräfte genommen</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>Zertifikatsnummer</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>konform</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>nicht konform</translation>
    </message>
    <message>
        <source>not decided: the error is nearer to the tolerance than the uncertainty allows to tell</source>
        <translation>unentschieden: die Abweichung liegt näher an der Toleranz, als die Unsicherheit zu unterscheiden erlaubt</translation>
    </message>
    <message>
        <source>largest error %1</source>
        <translation>größte Abweichung %1</translation>
    </message>
    <message>
        <source>Decision rule: it conforms where the largest error and the expanded uncertainty together are within the tolerance, and does not where the error less the uncertainty is beyond it (guard band of one expanded uncertainty, ILAC-G8:09/2019).</source>
        <translation>Entscheidungsregel: konform, wenn größte Abweichung und erweiterte Messunsicherheit zusammen innerhalb der Toleranz liegen; nicht konform, wenn die Abweichung abzüglich der Unsicherheit außerhalb liegt (Schutzabstand von einer erweiterten Messunsicherheit, ILAC-G8:09/2019).</translation>
    </message>
    <message>
        <source>Decision rule: it conforms where the largest error is within the tolerance, without regard to the uncertainty (simple acceptance, JCGM 106:2012).</source>
        <translation>Entscheidungsregel: konform, wenn die größte Abweichung innerhalb der Toleranz liegt, ohne Rücksicht auf die Unsicherheit (einfache Akzeptanz, JCGM 106:2012).</translation>
    </message>
    <message>
        <source>As found and as left</source>
        <translation>Vorgefunden und hinterlassen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Vorgefunden</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht festgehalten</translation>
    </message>
    <message>
        <source>As left</source>
        <translation>Hinterlassen</translation>
    </message>
    <message>
        <source>No tolerance was stated, so there is no statement of conformity.</source>
        <translation>Es wurde keine Toleranz angegeben, daher gibt es keine Konformitätsaussage.</translation>
    </message>
    <message>
        <source>As found: by the gripper&apos;s own scale, uncorrected until then.</source>
        <translation>Vorgefunden: nach der eigenen Skala des Greifers, bis dahin unkorrigiert.</translation>
    </message>
    <message>
        <source>As found: by the calibration that was in force until then.</source>
        <translation>Vorgefunden: nach der bis dahin gültigen Kalibrierung.</translation>
    </message>
    <message>
        <source>As left: the same readings by the new curve, which corrects them from now on. Nothing was adjusted in the gripper itself.</source>
        <translation>Hinterlassen: dieselben Anzeigen nach der neuen Kurve, die sie von nun an korrigiert. Am Greifer selbst wurde nichts justiert.</translation>
    </message>
    <message>
        <source>As left: by the new curve, at the points of a check that was taken afterwards and is no part of the curve. Nothing was adjusted in the gripper itself.</source>
        <translation>Hinterlassen: nach der neuen Kurve, an den Punkten einer Kontrolle, die danach aufgenommen wurde und nicht in die Kurve eingeht. Am Greifer selbst wurde nichts justiert.</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Erweiterungsfaktor</translation>
    </message>
    <message>
        <source>k = %1, coverage about 95 %</source>
        <translation>k = %1, Überdeckung etwa 95 %</translation>
    </message>
    <message>
        <source>The expanded uncertainty is the standard uncertainty times the coverage factor k, by Student&apos;s t. It holds a load found from one reading in 95 of 100 cases. It counts the scatter about the curve, the curve itself, the reference and the return of the zero (JCGM 100:2008). Percentages are of the span of the readings.</source>
        <translation>Die erweiterte Messunsicherheit ist die Standardunsicherheit mal dem Erweiterungsfaktor k, nach Student. Sie enthält eine Last, die aus einer Anzeige bestimmt wird, in 95 von 100 Fällen. Sie zählt die Streuung um die Kurve, die Kurve selbst, die Referenz und die Nullpunktrückkehr (JCGM 100:2008). Prozente beziehen sich auf die Spanne der Anzeigen.</translation>
    </message>
    <message>
        <source>Reading going up (%1)</source>
        <translation>Anzeige aufwärts (%1)</translation>
    </message>
    <message>
        <source>Reading going down (%1)</source>
        <translation>Anzeige abwärts (%1)</translation>
    </message>
    <message>
        <source>Difference (%1)</source>
        <translation>Differenz (%1)</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Mass (%1)</source>
        <translation>Masse (%1)</translation>
    </message>
    <message>
        <source>Error as found (%1)</source>
        <translation>Abweichung vorgefunden (%1)</translation>
    </message>
    <message>
        <source>Error as left (%1)</source>
        <translation>Abweichung hinterlassen (%1)</translation>
    </message>
    <message>
        <source>up</source>
        <translation>aufwärts</translation>
    </message>
    <message>
        <source>down</source>
        <translation>abwärts</translation>
    </message>
    <message>
        <source>Calibrated by %1, signature</source>
        <translation>Kalibriert von %1, Unterschrift</translation>
    </message>
    <message>
        <source>Released by, date, signature</source>
        <translation>Freigegeben von, Datum, Unterschrift</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Aufwärts und abwärts</translation>
    </message>
    <message>
        <source>Points of the check afterwards</source>
        <translation>Punkte der Kontrolle danach</translation>
    </message>
    <message>
        <source>Calibration certificate %1</source>
        <translation>Kalibrierzertifikat %1</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrationListModel</name>
    <message>
        <source>Taken</source>
        <translation>Am</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>Holds until</source>
        <translation>Gilt bis</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrationPlot</name>
    <message>
        <source>Residuals of the calibration</source>
        <translation>Residuen der Kalibrierung</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>What is left of each reading beside the curve appears here as soon as there are enough points.</source>
        <translation>Was von jeder Anzeige neben der Kurve bleibt, erscheint hier, sobald es genug Punkte gibt.</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Load (%1)</source>
        <translation>Last (%1)</translation>
    </message>
    <message>
        <source>Reading (%1)</source>
        <translation>Anzeige (%1)</translation>
    </message>
    <message>
        <source>Residual (%1)</source>
        <translation>Residuum (%1)</translation>
    </message>
    <message>
        <source>▲ up</source>
        <translation>▲ auf</translation>
    </message>
    <message>
        <source>■ down</source>
        <translation>■ ab</translation>
    </message>
</context>
<context>
    <name>gripscope::CalibrationPointsModel</name>
    <message>
        <source>up</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>down</source>
        <translation>ab</translation>
    </message>
    <message>
        <source>next</source>
        <translation>nächster</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
</context>
<context>
    <name>gripscope::CategoryPlot</name>
    <message>
        <source>Series</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
</context>
<context>
    <name>gripscope::CertificateDialog</name>
    <message>
        <source>The reference&apos;s certificate holds until</source>
        <translation>Das Zertifikat der Referenz gilt bis</translation>
    </message>
    <message>
        <source>Ambient temperature</source>
        <translation>Umgebungstemperatur</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Go through the loads once more at the end, as a check</source>
        <translation>Die Lasten am Ende noch einmal durchgehen, als Kontrolle</translation>
    </message>
    <message>
        <source>For the certificate</source>
        <translation>Für das Zertifikat</translation>
    </message>
    <message>
        <source>conforms with the uncertainty counted</source>
        <translation>konform unter Berücksichtigung der Unsicherheit</translation>
    </message>
    <message>
        <source>conforms by the error alone</source>
        <translation>konform nach der Abweichung allein</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Entscheidungsregel</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Übernehmen</translation>
    </message>
</context>
<context>
    <name>gripscope::ChannelScale</name>
    <message>
        <source>%1 (as recorded)</source>
        <translation>%1 (wie aufgenommen)</translation>
    </message>
</context>
<context>
    <name>gripscope::CheckList</name>
    <message>
        <source>Before the estimate</source>
        <translation>Vor der Schätzung</translation>
    </message>
</context>
<context>
    <name>gripscope::CheckSignLabel</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>suspect</source>
        <translation>fraglich</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>noted</source>
        <translation>vermerkt</translation>
    </message>
</context>
<context>
    <name>gripscope::CheckTrendPlot</name>
    <message>
        <source>Error (% of tolerance)</source>
        <translation>Fehler (% der Toleranz)</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>Checks on the reference object</source>
        <translation>Kontrollen am Referenzobjekt</translation>
    </message>
    <message>
        <source>The errors of the checks over time appear here.</source>
        <translation>Die Fehler der Kontrollen über der Zeit erscheinen hier.</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>%1 (% of tolerance)</source>
        <translation>%1 (% der Toleranz)</translation>
    </message>
    <message>
        <source>▲ m</source>
        <translation>▲ m</translation>
    </message>
    <message>
        <source>■ b</source>
        <translation>■ b</translation>
    </message>
    <message>
        <source>● k</source>
        <translation>● k</translation>
    </message>
</context>
<context>
    <name>gripscope::ClusterCountsModel</name>
    <message>
        <source>Cluster %1</source>
        <translation>Cluster %1</translation>
    </message>
</context>
<context>
    <name>gripscope::ClustersPanel</name>
    <message>
        <source>Grouping the squeezes…</source>
        <translation>Die Druckversuche werden gruppiert…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Clusters, without labels</source>
        <translation>Cluster, ohne Namen</translation>
    </message>
    <message>
        <source>K-means</source>
        <translation>K-Means</translation>
    </message>
    <message>
        <source>Gaussian mixture, tied</source>
        <translation>Gauß-Mischung, gemeinsam</translation>
    </message>
    <message>
        <source>Gaussian mixture, full</source>
        <translation>Gauß-Mischung, frei</translation>
    </message>
    <message>
        <source>Self-organizing map</source>
        <translation>Selbstorganisierende Karte</translation>
    </message>
    <message>
        <source>Round clusters of like size: each squeeze goes to the nearest centre</source>
        <translation>Runde Cluster ähnlicher Größe: Jeder Druckversuch geht zum nächsten Zentrum</translation>
    </message>
    <message>
        <source>Clusters of one shape, which all share: wiser with few squeezes</source>
        <translation>Cluster einer Form, die alle teilen: klüger bei wenigen Druckversuchen</translation>
    </message>
    <message>
        <source>Every cluster has a shape, a size and a share of its own</source>
        <translation>Jeder Cluster hat eigene Form, Größe und eigenen Anteil</translation>
    </message>
    <message>
        <source>Kohonen&apos;s map: a net of units that spreads over the squeezes; units that are alike are then merged</source>
        <translation>Kohonens Karte: ein Netz von Einheiten, das sich über die Druckversuche legt; ähnliche Einheiten werden dann vereinigt</translation>
    </message>
    <message>
        <source>Method of clustering</source>
        <translation>Verfahren der Gruppierung</translation>
    </message>
    <message>
        <source>raw values</source>
        <translation>Rohwerte</translation>
    </message>
    <message>
        <source>z-scores</source>
        <translation>z-Werte</translation>
    </message>
    <message>
        <source>logarithms</source>
        <translation>Logarithmen</translation>
    </message>
    <message>
        <source>z-scores of logs</source>
        <translation>z-Werte der Logarithmen</translation>
    </message>
    <message>
        <source>Scaling of m, b and k before clustering</source>
        <translation>Skalierung von m, b und k vor dem Gruppieren</translation>
    </message>
    <message>
        <source>How m, b and k are scaled before squeezes are compared</source>
        <translation>Wie m, b und k skaliert werden, bevor Druckversuche verglichen werden</translation>
    </message>
    <message>
        <source>best of 10 starts</source>
        <translation>bester von 10 Starts</translation>
    </message>
    <message>
        <source>random start %1</source>
        <translation>Zufallsstart %1</translation>
    </message>
    <message>
        <source>Where the method starts</source>
        <translation>Wo das Verfahren beginnt</translation>
    </message>
    <message>
        <source>Number of clusters</source>
        <translation>Anzahl der Cluster</translation>
    </message>
    <message>
        <source>Number of clusters K</source>
        <translation>Anzahl der Cluster K</translation>
    </message>
    <message>
        <source>Types against clusters</source>
        <translation>Typen gegen Cluster</translation>
    </message>
    <message>
        <source>A map starts from the plane of the two widest directions, and from 9 random draws; the best is kept</source>
        <translation>Eine Karte beginnt mit der Ebene der zwei weitesten Richtungen und mit 9 Zufallsziehungen; die beste bleibt</translation>
    </message>
    <message>
        <source>A single random start takes more steps and may end in the wrong clusters</source>
        <translation>Ein einzelner Zufallsstart braucht mehr Schritte und kann in falschen Clustern enden</translation>
    </message>
    <message>
        <source>Adjusted Rand index</source>
        <translation>Adjustierter Rand-Index</translation>
    </message>
    <message>
        <source>1: the clusters are the types; about 0: no better than chance</source>
        <translation>1: Die Cluster sind die Typen; etwa 0: nicht besser als Zufall</translation>
    </message>
    <message>
        <source>With a single type there is nothing to agree with</source>
        <translation>Bei einem einzigen Typ gibt es nichts zu vergleichen</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>%1 × %2 units</source>
        <translation>%1 × %2 Einheiten</translation>
    </message>
    <message>
        <source>About 5 times the square root of the squeezes</source>
        <translation>Etwa das 5-Fache der Wurzel aus der Zahl der Druckversuche</translation>
    </message>
    <message>
        <source>Quantisation error</source>
        <translation>Quantisierungsfehler</translation>
    </message>
    <message>
        <source>Mean distance of a squeeze from its unit, in the scaled space</source>
        <translation>Mittlerer Abstand eines Druckversuchs von seiner Einheit, im skalierten Raum</translation>
    </message>
    <message>
        <source>Topographic error</source>
        <translation>Topografischer Fehler</translation>
    </message>
    <message>
        <source>Share of the squeezes whose two nearest units are no neighbours; over a tenth or so the net is folded</source>
        <translation>Anteil der Druckversuche, deren zwei nächste Einheiten keine Nachbarn sind; ab etwa einem Zehntel ist das Netz gefaltet</translation>
    </message>
    <message>
        <source>Log-likelihood</source>
        <translation>Log-Likelihood</translation>
    </message>
    <message>
        <source>Of all squeezes under the mixture, in the scaled space</source>
        <translation>Aller Druckversuche unter der Mischung, im skalierten Raum</translation>
    </message>
    <message>
        <source>BIC</source>
        <translation>BIC</translation>
    </message>
    <message>
        <source>Likelihood less a price for each parameter: the lower, the better</source>
        <translation>Likelihood abzüglich eines Preises je Parameter: je niedriger, desto besser</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Sum of squared distances to the own centre, in the scaled space</source>
        <translation>Summe der quadrierten Abstände zum eigenen Zentrum, im skalierten Raum</translation>
    </message>
    <message>
        <source>Table 1: types against clusters</source>
        <translation>Tabelle 1: Typen gegen Cluster</translation>
    </message>
    <message>
        <source>A column a type, a row a squeeze, in each cell its cluster</source>
        <translation>Eine Spalte je Typ, eine Zeile je Druckversuch, in jeder Zelle sein Cluster</translation>
    </message>
    <message>
        <source>A row a type, a column a cluster, in each cell how many squeezes</source>
        <translation>Eine Zeile je Typ, eine Spalte je Cluster, in jeder Zelle die Zahl der Druckversuche</translation>
    </message>
</context>
<context>
    <name>gripscope::ComparisonTableModel</name>
    <message>
        <source>best</source>
        <translation>bestes</translation>
    </message>
    <message>
        <source>How much worse the information criterion is than the best model&apos;s; below 10 decides nothing</source>
        <translation>Wie viel schlechter das Informationskriterium ist als das des besten Modells; unter 10 entscheidet nichts</translation>
    </message>
    <message>
        <source>Largest change of m, b or k from the linear model&apos;s, in its standard errors</source>
        <translation>Größte Änderung von m, b oder k gegenüber dem linearen Modell, in dessen Standardfehlern</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>change
sd</source>
        <translation>Änd.
σ</translation>
    </message>
    <message>
        <source>sim.
%</source>
        <translation>Sim.
%</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Cubic spring</source>
        <translation>Kubische Feder</translation>
    </message>
    <message>
        <source>Without offset</source>
        <translation>Ohne Nullpunkt</translation>
    </message>
    <message>
        <source>With offset</source>
        <translation>Mit Nullpunkt</translation>
    </message>
    <message>
        <source>With a delay</source>
        <translation>Mit Verzögerung</translation>
    </message>
    <message>
        <source>Other force hold</source>
        <translation>Anderer Kraftverlauf</translation>
    </message>
    <message>
        <source>Smooth force</source>
        <translation>Glatte Kraft</translation>
    </message>
</context>
<context>
    <name>gripscope::ConnectMenu</name>
    <message>
        <source>Grippers</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>This gripper</source>
        <translation>Dieser Greifer</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Connect to a gripper</source>
        <translation>Mit einem Greifer verbinden</translation>
    </message>
    <message>
        <source>no serial number</source>
        <translation>keine Seriennummer</translation>
    </message>
    <message>
        <source>serial %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>an %1</translation>
    </message>
    <message>
        <source>no permission: see what to type</source>
        <translation>nicht erlaubt: siehe, was einzugeben ist</translation>
    </message>
    <message>
        <source>used last</source>
        <translation>zuletzt benutzt</translation>
    </message>
    <message>
        <source>Looking for grippers on USB…</source>
        <translation>Suche nach Greifern am USB…</translation>
    </message>
    <message>
        <source>Virtual gripper, can %1</source>
        <translation>Virtueller Greifer, Dose %1</translation>
    </message>
    <message>
        <source>Other address…</source>
        <translation>Andere Adresse…</translation>
    </message>
    <message>
        <source>Inspect the gripper…</source>
        <translation>Greifer untersuchen…</translation>
    </message>
    <message>
        <source>Measure the lag between its channels…</source>
        <translation>Zeitversatz seiner Kanäle messen…</translation>
    </message>
    <message>
        <source>Profile of another maker&apos;s gripper…</source>
        <translation>Profil für Greifer anderer Hersteller…</translation>
    </message>
    <message>
        <source>Do not wait for the gripper</source>
        <translation>Nicht auf den Greifer warten</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Keep the raw reports of every session</source>
        <translation>Rohdaten jeder Sitzung aufbewahren</translation>
    </message>
    <message>
        <source>From the next connection on, the raw reports of grippers are kept in %1.</source>
        <translation>Ab der nächsten Verbindung werden die Rohdaten der Greifer in %1 aufbewahrt.</translation>
    </message>
    <message>
        <source>From the next connection on, raw reports are not kept. Squeezes cannot be replayed then.</source>
        <translation>Ab der nächsten Verbindung werden Rohdaten nicht aufbewahrt. Druckversuche lassen sich dann nicht wiedergeben.</translation>
    </message>
    <message>
        <source>No gripper found on USB</source>
        <translation>Kein Greifer am USB gefunden</translation>
    </message>
    <message>
        <source>Address, such as virtual:?object=B&amp;seed=7, hid: or replay:FILE</source>
        <translation>Adresse, etwa virtual:?object=B&amp;seed=7, hid: oder replay:FILE</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Press the virtual gripper&apos;s button</source>
        <translation>Knopf des virtuellen Greifers drücken</translation>
    </message>
    <message>
        <source>A part leans on the virtual gripper</source>
        <translation>Ein Teil lehnt am virtuellen Greifer</translation>
    </message>
    <message>
        <source>Virtual gripper, foam that goes on yielding</source>
        <translation>Virtueller Greifer, Schaumstoff, der weiter nachgibt</translation>
    </message>
    <message>
        <source>Virtual gripper, worn: 1 N of friction</source>
        <translation>Virtueller Greifer, abgenutzt: 1 N Reibung</translation>
    </message>
    <message>
        <source>Virtual gripper, slow: 100 samples a second</source>
        <translation>Virtueller Greifer, langsam: 100 Abtastwerte je Sekunde</translation>
    </message>
    <message>
        <source>Virtual gripper, tomato</source>
        <translation>Virtueller Greifer, Tomate</translation>
    </message>
</context>
<context>
    <name>gripscope::Connection</name>
    <message>
        <source>%1 kHz</source>
        <translation>%L1 kHz</translation>
    </message>
    <message>
        <source>%1 · %2 lost</source>
        <translation>%1 · %2 verloren</translation>
    </message>
    <message>
        <source>Gripper %1</source>
        <translation>Greifer %1</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbinde…</translation>
    </message>
    <message>
        <source>No permission</source>
        <translation>Nicht erlaubt</translation>
    </message>
    <message>
        <source>see what to type</source>
        <translation>siehe Eingabe</translation>
    </message>
    <message>
        <source>Gripper lost</source>
        <translation>Greifer verloren</translation>
    </message>
    <message>
        <source>choose one</source>
        <translation>einen wählen</translation>
    </message>
    <message>
        <source>%1 is away</source>
        <translation>%1 ist weg</translation>
    </message>
    <message>
        <source>No gripper yet</source>
        <translation>Noch kein Greifer</translation>
    </message>
    <message>
        <source>waiting for it</source>
        <translation>wird erwartet</translation>
    </message>
    <message>
        <source>No gripper</source>
        <translation>Kein Greifer</translation>
    </message>
    <message>
        <source>Choose the gripper at the top to see what to type</source>
        <translation>Oben den Greifer wählen, um zu sehen, was einzugeben ist</translation>
    </message>
    <message>
        <source>Choose one at the top of the window</source>
        <translation>Oben im Fenster einen wählen</translation>
    </message>
    <message>
        <source>Plug it in: Gripscope connects it by itself</source>
        <translation>Anstecken: Gripscope verbindet ihn von selbst</translation>
    </message>
    <message>
        <source>Plug it in again: Gripscope goes on by itself</source>
        <translation>Wieder anstecken: Gripscope macht von selbst weiter</translation>
    </message>
    <message>
        <source>The gripper at %1 may not be opened by this user. Choose it at the top to see what to type; Gripscope connects it by itself then.</source>
        <translation>Dieser Benutzer darf den Greifer unter %1 nicht öffnen. Oben wählen, um zu sehen, was einzugeben ist; danach verbindet Gripscope ihn von selbst.</translation>
    </message>
    <message>
        <source>%1 went away: %2. Plug it in again: Gripscope goes on by itself.</source>
        <translation>%1 ist weg: %2. Wieder anstecken: Gripscope macht von selbst weiter.</translation>
    </message>
    <message>
        <source>%1 Gripscope connects it as soon as it is there.</source>
        <translation>%1 Gripscope verbindet ihn, sobald er da ist.</translation>
    </message>
    <message>
        <source>%1 went away during the squeeze, so nothing was measured. Plug it in again, arm it, then repeat the squeeze.</source>
        <translation>%1 verschwand während des Druckversuchs, also wurde nichts gemessen. Wieder anstecken, scharf schalten, dann erneut drücken.</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>%1 · %2 lost earlier</source>
        <translation>%1 · %2 früher verloren</translation>
    </message>
</context>
<context>
    <name>gripscope::ControlView</name>
    <message>
        <source>%1: inspection</source>
        <translation>%1: Prüfung</translation>
    </message>
    <message>
        <source>%1: time (UTC)</source>
        <translation>%1: Zeit (UTC)</translation>
    </message>
    <message>
        <source>%1: lower sum</source>
        <translation>%1: untere Summe</translation>
    </message>
    <message>
        <source>%1: lower limit</source>
        <translation>%1: untere Grenze</translation>
    </message>
    <message>
        <source>%1: upper limit</source>
        <translation>%1: obere Grenze</translation>
    </message>
    <message>
        <source>%1: signal</source>
        <translation>%1: Signal</translation>
    </message>
    <message>
        <source>Control charts</source>
        <translation>Regelkarten</translation>
    </message>
</context>
<context>
    <name>gripscope::CorrelationPlot</name>
    <message>
        <source>95 % band</source>
        <translation>95-%-Band</translation>
    </message>
    <message numerus="yes">
        <source>%n lag(s) outside of the 95 % band</source>
        <translation>
            <numerusform>%n Versatz außerhalb des 95-%-Bands</numerusform>
            <numerusform>%n Versätze außerhalb des 95-%-Bands</numerusform>
        </translation>
    </message>
    <message>
        <source>Lag (samples)</source>
        <translation>Versatz (Abtastwerte)</translation>
    </message>
    <message>
        <source>Lag (ms)</source>
        <translation>Versatz (ms)</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>95 % band (half width)</source>
        <translation>95-%-Band (halbe Breite)</translation>
    </message>
</context>
<context>
    <name>gripscope::CoursePlot</name>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
</context>
<context>
    <name>gripscope::DeterminedText</name>
    <message>
        <source>Mass m</source>
        <translation>Masse m</translation>
    </message>
    <message>
        <source>Damping b</source>
        <translation>Dämpfung b</translation>
    </message>
    <message>
        <source>Stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>Friction Fc</source>
        <translation>Reibung Fc</translation>
    </message>
    <message>
        <source>Yielding stiffness k1</source>
        <translation>Nachgebende Steifigkeit k1</translation>
    </message>
    <message>
        <source>Yields within τ</source>
        <translation>Gibt nach in τ</translation>
    </message>
    <message>
        <source>Cubic stiffness k3</source>
        <translation>Kubische Steifigkeit k3</translation>
    </message>
    <message>
        <source>Damping back b</source>
        <translation>Dämpfung zurück b</translation>
    </message>
    <message>
        <source>Friction back Fc</source>
        <translation>Reibung zurück Fc</translation>
    </message>
    <message>
        <source>Offset of the force</source>
        <translation>Nullpunktversatz der Kraft</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
</context>
<context>
    <name>gripscope::DeviceChip</name>
    <message>
        <source>Gripper: %1</source>
        <translation>Greifer: %1</translation>
    </message>
    <message>
        <source>%1 · reports are being lost</source>
        <translation>%1 · Reports gehen verloren</translation>
    </message>
</context>
<context>
    <name>gripscope::DeviceInspector</name>
    <message>
        <source>Gripper inspector</source>
        <translation>Greifer untersuchen</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identität</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Reports</translation>
    </message>
    <message>
        <source>Counters</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>Descriptor</source>
        <translation>Deskriptor</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>In words</source>
        <translation>In Worten</translation>
    </message>
    <message>
        <source>Report descriptor</source>
        <translation>Report-Deskriptor</translation>
    </message>
    <message>
        <source>Copy the bytes</source>
        <translation>Bytes kopieren</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>Since it was opened</source>
        <translation>Seit dem Öffnen</translation>
    </message>
    <message>
        <source>Since I looked</source>
        <translation>Seit Zählbeginn</translation>
    </message>
    <message>
        <source>Count from here on</source>
        <translation>Ab hier zählen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>USB vendor and product</source>
        <translation>USB-Hersteller und -Produkt</translation>
    </message>
    <message>
        <source>Device node</source>
        <translation>Geräteknoten</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>force in %1, position in %2</source>
        <translation>Kraft in %1, Weg in %2</translation>
    </message>
    <message>
        <source>Sample time</source>
        <translation>Abtastzeit</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Position later than force by</source>
        <translation>Weg später als Kraft um</translation>
    </message>
    <message>
        <source>%1 µs, as it says</source>
        <translation>%1 µs, nach eigener Angabe</translation>
    </message>
    <message>
        <source>Takes commands</source>
        <translation>Nimmt Befehle an</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no, it only streams</source>
        <translation>nein, er sendet nur</translation>
    </message>
    <message>
        <source>Its own limits</source>
        <translation>Seine eigenen Grenzen</translation>
    </message>
    <message>
        <source>There is no report descriptor: this is no USB device.</source>
        <translation>Es gibt keinen Report-Deskriptor: Dies ist kein USB-Gerät.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Samples lost on the way</source>
        <translation>Unterwegs verlorene Abtastwerte</translation>
    </message>
    <message>
        <source>Places where samples are missing</source>
        <translation>Stellen, an denen Abtastwerte fehlen</translation>
    </message>
    <message>
        <source>Samples dropped here</source>
        <translation>Hier verworfene Abtastwerte</translation>
    </message>
    <message>
        <source>Reports that came twice</source>
        <translation>Doppelt angekommene Reports</translation>
    </message>
    <message>
        <source>Damaged reports</source>
        <translation>Beschädigte Reports</translation>
    </message>
    <message>
        <source>Silences of 50 ms and more</source>
        <translation>Stille von 50 ms und mehr</translation>
    </message>
    <message>
        <source>Jumps of the gripper&apos;s clock</source>
        <translation>Sprünge der Uhr des Greifers</translation>
    </message>
    <message>
        <source>Commands sent</source>
        <translation>Gesendete Befehle</translation>
    </message>
    <message>
        <source>Commands repeated</source>
        <translation>Wiederholte Befehle</translation>
    </message>
    <message>
        <source>Commands answered</source>
        <translation>Beantwortete Befehle</translation>
    </message>
    <message>
        <source>Commands refused</source>
        <translation>Abgelehnte Befehle</translation>
    </message>
    <message>
        <source>Commands without an answer</source>
        <translation>Befehle ohne Antwort</translation>
    </message>
    <message>
        <source>Heartbeats</source>
        <translation>Lebenszeichen</translation>
    </message>
    <message>
        <source>Longest silence</source>
        <translation>Längste Stille</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>Clock beside the computer&apos;s</source>
        <translation>Uhr gegenüber der des Rechners</translation>
    </message>
    <message>
        <source>Until the program took a sample over</source>
        <translation>Bis das Programm einen Abtastwert übernahm</translation>
    </message>
    <message>
        <source>%1 ± %2 ppm</source>
        <translation>%1 ± %2 ppm</translation>
    </message>
    <message>
        <source>%1, %2, %3 samples</source>
        <translation>%1, %2, %3 Abtastwerte</translation>
    </message>
</context>
<context>
    <name>gripscope::DriftView</name>
    <message>
        <source>All studies</source>
        <translation>Alle Studien</translation>
    </message>
    <message>
        <source>How many inspections are looked at</source>
        <translation>Wie viele Prüfungen angesehen werden</translation>
    </message>
    <message>
        <source>Newest %1</source>
        <translation>Neueste %1</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>All grippers</source>
        <translation>Alle Greifer</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>All stations</source>
        <translation>Alle Stationen</translation>
    </message>
    <message>
        <source>What moved</source>
        <translation>Was sich verschoben hat</translation>
    </message>
    <message>
        <source>Shifts by type</source>
        <translation>Verschiebungen nach Typ</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>By chance</source>
        <translation>Durch Zufall</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Regelkarten</translation>
    </message>
    <message>
        <source>Being read…</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>No type is approved</source>
        <translation>Kein Typ ist freigegeben</translation>
    </message>
    <message>
        <source>No inspection to look at</source>
        <translation>Keine Prüfung zum Ansehen</translation>
    </message>
    <message>
        <source>Enrol types and approve them; what is inspected then is held against them.</source>
        <translation>Typen einlernen und freigeben; was dann geprüft wird, wird mit ihnen verglichen.</translation>
    </message>
    <message>
        <source>No inspected squeeze of an approved type is among those that are chosen.</source>
        <translation>Unter den gewählten ist kein geprüfter Druckversuch eines freigegebenen Typs.</translation>
    </message>
    <message>
        <source>What to do next: %1</source>
        <translation>Was als Nächstes zu tun ist: %1</translation>
    </message>
    <message>
        <source>Squeezes of approved types: %1. Inspections left out: %2, of no known type, not valid or void. A type is said to have moved where none has in one look of a hundred.</source>
        <translation>Druckversuche freigegebener Typen: %1. Ausgelassene Prüfungen: %2, von keinem bekannten Typ, ungültig oder storniert. Dass sich ein Typ verschoben hat, wird in einem von hundert Fällen gemeldet, in denen es nicht stimmt.</translation>
    </message>
    <message>
        <source>alarm at squeeze %1</source>
        <translation>Alarm bei Versuch %1</translation>
    </message>
    <message>
        <source>quiet</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Alle zusammen</translation>
    </message>
    <message>
        <source>one factor fits all: %1</source>
        <translation>ein Faktor passt für alle: %1</translation>
    </message>
</context>
<context>
    <name>gripscope::EmptyGripperStep</name>
    <message>
        <source>Squeeze nothing (Space)</source>
        <translation>Leer drücken (Leertaste)</translation>
    </message>
    <message>
        <source>Measure again (Space)</source>
        <translation>Neu messen (Leertaste)</translation>
    </message>
    <message>
        <source>Take it off from now on</source>
        <translation>Ab jetzt abziehen</translation>
    </message>
    <message numerus="yes">
        <source>Fingers and drive have m, b, k and friction of their own, which add to the part&apos;s. Take everything out of the gripper: it squeezes nothing, %n times, with the force of the parts.</source>
        <translation>
            <numerusform>Finger und Antrieb haben m, b, k und Reibung, die zu denen des Teils hinzukommen. Alles aus dem Greifer nehmen: Er drückt %n-mal ins Leere, mit der Kraft der Teile.</numerusform>
            <numerusform>Finger und Antrieb haben m, b, k und Reibung, die zu denen des Teils hinzukommen. Alles aus dem Greifer nehmen: Er drückt %n-mal ins Leere, mit der Kraft der Teile.</numerusform>
        </translation>
    </message>
    <message>
        <source>k %1</source>
        <translation>k %1</translation>
    </message>
    <message>
        <source>m %1, b %2, k %3 (95 %)</source>
        <translation>m %1, b %2, k %3 (95 %)</translation>
    </message>
    <message>
        <source>, friction %1</source>
        <translation>, Reibung %1</translation>
    </message>
    <message>
        <source>In use for gripper %1: %2.</source>
        <translation>In Gebrauch für Greifer %1: %2.</translation>
    </message>
    <message>
        <source>The empty gripper: %1.</source>
        <translation>Der leere Greifer: %1.</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollCheck</name>
    <message>
        <source>What held-out squeezes are called</source>
        <translation>Wie ausgelassene Druckversuche benannt werden</translation>
    </message>
    <message>
        <source>Squeezes
of</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>as
itself</source>
        <translation>als er
selbst</translation>
    </message>
    <message>
        <source>another
type</source>
        <translation>anderer
Typ</translation>
    </message>
    <message>
        <source>un-
known</source>
        <translation>unbe-
kannt</translation>
    </message>
    <message>
        <source>incon-
clusive</source>
        <translation>unent-
schieden</translation>
    </message>
    <message>
        <source>wrong at
most (95 %)</source>
        <translation>falsch
max.
(95 %)</translation>
    </message>
    <message>
        <source>Each squeeze is being judged by all the others…</source>
        <translation>Jeder Druckversuch wird anhand aller anderen beurteilt…</translation>
    </message>
    <message>
        <source>A type needs two squeezes, of two parts, to be checked.</source>
        <translation>Zum Prüfen braucht ein Typ zwei Druckversuche an zwei Teilen.</translation>
    </message>
    <message>
        <source>Each squeeze judged by all the others. Another type: %1 Unknown: %2</source>
        <translation>Jeder Druckversuch anhand aller anderen beurteilt. Anderer Typ: %1 Unbekannt: %2</translation>
    </message>
    <message>
        <source>Squeeze %1 does not go with the others. %2</source>
        <translation>Druckversuch %1 passt nicht zu den anderen. %2</translation>
    </message>
    <message>
        <source>No other type overlaps it.</source>
        <translation>Kein anderer Typ überlappt ihn.</translation>
    </message>
    <message>
        <source>Stiffness differs by %1 from part to part and by %2 from grip to grip (1 sd, all types).</source>
        <translation>Die Steifigkeit unterscheidet sich um %1 von Teil zu Teil und um %2 von Griff zu Griff (1 σ, alle Typen).</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollDrafts</name>
    <message>
        <source>Named, and not squeezed yet.</source>
        <translation>Benannt, noch nicht gedrückt.</translation>
    </message>
    <message numerus="yes">
        <source>%n squeeze(s), ready for approval.</source>
        <translation>
            <numerusform>%n Druckversuch, bereit zur Freigabe.</numerusform>
            <numerusform>%n Druckversuche, bereit zur Freigabe.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Left on %2.</source>
        <translation>%1 Verlassen am %2.</translation>
    </message>
    <message>
        <source>%1 Left by %2 on %3.</source>
        <translation>%1 Verlassen von %2 am %3.</translation>
    </message>
    <message>
        <source>Begun and not finished</source>
        <translation>Begonnen und nicht beendet</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>“%1” was discarded.</source>
        <translation>„%1“ wurde verworfen.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Go on with %1</source>
        <translation>%1 fortsetzen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Discard the enrolment of %1</source>
        <translation>Das Einlernen von %1 verwerfen</translation>
    </message>
    <message>
        <source>It is offered no more; accepted squeezes stay, see Enrolled types</source>
        <translation>Es wird nicht mehr angeboten; angenommene Druckversuche bleiben, siehe Eingelernte Typen</translation>
    </message>
    <message>
        <source>It is offered no more</source>
        <translation>Es wird nicht mehr angeboten</translation>
    </message>
    <message>
        <source>Squeezes so far: %1.</source>
        <translation>Bisherige Druckversuche: %1.</translation>
    </message>
    <message>
        <source>Squeezes so far: %1, and one to decide on.</source>
        <translation>Bisherige Druckversuche: %1; über einen weiteren ist zu entscheiden.</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollNameStep</name>
    <message>
        <source>What is the type called?</source>
        <translation>Wie heißt der Typ?</translation>
    </message>
    <message>
        <source>As a technician would say it, for instance “Cola 330 ml”. The name appears in large letters when a part of this type is inspected.</source>
        <translation>So, wie man ihn am Platz nennt, zum Beispiel „Cola 330 ml“. Der Name erscheint groß, wenn ein Teil dieses Typs geprüft wird.</translation>
    </message>
    <message>
        <source>Name of the type</source>
        <translation>Name des Typs</translation>
    </message>
    <message>
        <source>Continue (Enter)</source>
        <translation>Weiter (Eingabe)</translation>
    </message>
    <message>
        <source>Enrolled types…</source>
        <translation>Eingelernte Typen…</translation>
    </message>
    <message>
        <source>Rename, merge, split or retire types; undo changes</source>
        <translation>Typen umbenennen, zusammenführen, aufteilen oder außer Gebrauch nehmen; Änderungen rückgängig machen</translation>
    </message>
    <message>
        <source>Type %1</source>
        <translation>Typ %1</translation>
    </message>
    <message>
        <source>This type is known (squeezes so far: %1). The enrolment goes on with its own recipe.</source>
        <translation>Dieser Typ ist bekannt (bisherige Druckversuche: %1). Das Einlernen geht mit seinem eigenen Rezept weiter.</translation>
    </message>
    <message>
        <source>This enrolment was begun before. It goes on with the squeezes that it has.</source>
        <translation>Dieses Einlernen wurde schon begonnen. Es geht mit seinen Druckversuchen weiter.</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollPage</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsehen</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Enroll</source>
        <translation>Einlernen</translation>
    </message>
    <message>
        <source>How is it squeezed?</source>
        <translation>Wie wird gedrückt?</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Parts of this type are recognised from now on. More squeezes can be added later under the same name.</source>
        <translation>Teile dieses Typs werden ab jetzt erkannt. Weitere Druckversuche können später unter demselben Namen hinzukommen.</translation>
    </message>
    <message>
        <source>Enroll another type</source>
        <translation>Anderen Typ einlernen</translation>
    </message>
    <message>
        <source>Inspect parts</source>
        <translation>Teile prüfen</translation>
    </message>
    <message>
        <source>%1 is known: its recipe stays as it is, so that all its squeezes can be compared.</source>
        <translation>%1 ist bekannt: Sein Rezept bleibt, damit alle seine Druckversuche vergleichbar sind.</translation>
    </message>
    <message>
        <source>%1 is enrolled with %2 squeezes.</source>
        <translation>%1 ist mit %2 Druckversuchen eingelernt.</translation>
    </message>
    <message>
        <source>Cola 330 ml</source>
        <translation>Cola 330 ml</translation>
    </message>
    <message>
        <source>Leave for later</source>
        <translation>Später weiter</translation>
    </message>
    <message>
        <source>Keeps this enrolment as it is and goes back to the first step</source>
        <translation>Behält dieses Einlernen, wie es ist, und geht zum ersten Schritt zurück</translation>
    </message>
    <message>
        <source>Continue (Enter)</source>
        <translation>Weiter (Eingabe)</translation>
    </message>
    <message>
        <source>Undo: discard an enrolment (Ctrl+Z)</source>
        <translation>Rückgängig: ein Einlernen verwerfen (Strg+Z)</translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation>Rückgängig: %1 (Strg+Z)</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z): nothing now</source>
        <translation>Rückgängig (Strg+Z): jetzt nichts</translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Shift+Z)</source>
        <translation>Wiederholen: %1 (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Shift+Z): nothing now</source>
        <translation>Wiederholen (Strg+Umschalt+Z): jetzt nichts</translation>
    </message>
    <message>
        <source>the name</source>
        <translation>den Namen</translation>
    </message>
    <message>
        <source>the recipe</source>
        <translation>das Rezept</translation>
    </message>
    <message>
        <source>going to the review</source>
        <translation>zur Durchsicht gehen</translation>
    </message>
    <message>
        <source>taking squeeze %1</source>
        <translation>Druckversuch %1</translation>
    </message>
    <message>
        <source>accepting squeeze %1</source>
        <translation>Annahme von Druckversuch %1</translation>
    </message>
    <message>
        <source>rejecting squeeze %1</source>
        <translation>Ablehnung von Druckversuch %1</translation>
    </message>
    <message>
        <source>dropping squeeze %1</source>
        <translation>Streichen von Druckversuch %1</translation>
    </message>
    <message>
        <source>%1 is approved. With the first squeeze that is added its approval is void: its parts are not recognised until it is approved again. Its recipe stays as it is.</source>
        <translation>%1 ist freigegeben. Mit dem ersten Druckversuch, der hinzukommt, erlischt die Freigabe: Teile dieses Typs werden nicht erkannt, bis er erneut freigegeben ist. Sein Rezept bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Pushes and releases about a preload; no squeeze of this type goes above the crush limit.</source>
        <translation>Drücken und Nachlassen um eine Vorlast, nie über die Bruchgrenze.</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollPictureField</name>
    <message>
        <source>Choose picture…</source>
        <translation>Bild wählen…</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the picture</source>
        <translation>Das Bild entfernen</translation>
    </message>
    <message>
        <source>Shown with the type, so that nobody takes one for another.</source>
        <translation>Wird beim Typ gezeigt, damit niemand einen mit dem anderen verwechselt.</translation>
    </message>
    <message>
        <source>A picture of the part, if you like: choose a PNG or JPEG file, drop it here, or paste it.</source>
        <translation>Auf Wunsch ein Bild des Teils: eine PNG- oder JPEG-Datei wählen, hier ablegen oder einfügen.</translation>
    </message>
    <message>
        <source>Picture of the part</source>
        <translation>Bild des Teils</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>Das Bild wird gelesen…</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollRecipeForm</name>
    <message>
        <source>Preload</source>
        <translation>Vorlast</translation>
    </message>
    <message>
        <source>Push and release</source>
        <translation>Drücken und Nachlassen</translation>
    </message>
    <message>
        <source>Shortest push</source>
        <translation>Kürzestes Drücken</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Crush limit</source>
        <translation>Bruchgrenze</translation>
    </message>
    <message>
        <source>Travel limit</source>
        <translation>Weggrenze</translation>
    </message>
    <message>
        <source>This gripper holds at most %1 s of force. Choose a shorter squeeze.</source>
        <translation>Dieser Greifer fasst höchstens %1 s Kraftverlauf. Einen kürzeren Druckversuch wählen.</translation>
    </message>
    <message>
        <source>The push and release is larger than the preload: the gripper would have to pull. Raise the preload to at least %1.</source>
        <translation>Drücken und Nachlassen ist größer als die Vorlast: Der Greifer müsste ziehen. Die Vorlast auf mindestens %1 erhöhen.</translation>
    </message>
    <message>
        <source>The largest force is %1, and this gripper allows %2. Choose less.</source>
        <translation>Die größte Kraft ist %1, dieser Greifer erlaubt %2. Weniger wählen.</translation>
    </message>
    <message>
        <source>The force goes from %1 to %2 for %3 s. The gripper stops by itself at %4 or %5.</source>
        <translation>Die Kraft geht %3 s lang von %1 bis %2. Der Greifer hält bei %4 oder %5 von selbst an.</translation>
    </message>
    <message>
        <source>How the force goes</source>
        <translation>Form der Kraft</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollReviewPanel</name>
    <message>
        <source>Mean (95 %)</source>
        <translation>Mittel (95 %)</translation>
    </message>
    <message>
        <source>Spread (1 sd)</source>
        <translation>Streuung (1 σ)</translation>
    </message>
    <message>
        <source>moving mass m</source>
        <translation>bewegte Masse m</translation>
    </message>
    <message>
        <source>damping b</source>
        <translation>Dämpfung b</translation>
    </message>
    <message>
        <source>stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>Held-out check</source>
        <translation>Kreuzprüfung</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Back to the squeezes</source>
        <translation>Zu den Druckversuchen</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Review of %1</source>
        <translation>Durchsicht von %1</translation>
    </message>
    <message>
        <source>Review of %1: %2 squeezes</source>
        <translation>Durchsicht von %1: %2 Druckversuche</translation>
    </message>
    <message>
        <source>It is the only type that it can be compared with; enroll others to see how far they are.</source>
        <translation>Es ist der einzige Typ, mit dem zu vergleichen wäre; weitere einlernen, um die Abstände zu sehen.</translation>
    </message>
    <message>
        <source>The nearest other type, %1, is only %2 sd away: within the gate. Squeezes of the two will be mixed up. Choose a recipe that tells them apart, or treat them as one type.</source>
        <translation>Der nächste andere Typ, %1, ist nur %L2 σ entfernt: innerhalb der Grenze. Druckversuche der beiden werden verwechselt. Ein Rezept wählen, das sie trennt, oder beide als einen Typ behandeln.</translation>
    </message>
    <message>
        <source>The nearest other type is %1, %2 sd away.</source>
        <translation>Der nächste andere Typ ist %1, %L2 σ entfernt.</translation>
    </message>
    <message>
        <source>Too few squeezes for a gate yet: every verdict on this type stays inconclusive. Add some.</source>
        <translation>Noch zu wenige Druckversuche für eine Grenze: Jedes Urteil zu diesem Typ bleibt unentschieden. Weitere hinzufügen.</translation>
    </message>
    <message>
        <source>Squeezes: %1 accepted</source>
        <translation>Druckversuche: %1 angenommen</translation>
    </message>
    <message>
        <source>Squeezes: %1 accepted, %2 not</source>
        <translation>Druckversuche: %1 angenommen, %2 nicht</translation>
    </message>
    <message numerus="yes">
        <source>Of %n part(s) with a mark</source>
        <translation>
            <numerusform>Von %n bezeichneten Teil</numerusform>
            <numerusform>Von %n bezeichneten Teilen</numerusform>
        </translation>
    </message>
    <message>
        <source>Force: %1 to %2 for %3 s</source>
        <translation>Kraft: %1 bis %2, %3 s lang</translation>
    </message>
    <message>
        <source>Crush limit: %1, %2</source>
        <translation>Bruchgrenze: %1, %2</translation>
    </message>
    <message>
        <source>A squeeze further than %1 sd from the type is called unknown (%2 of its own squeezes are).</source>
        <translation>Ein Druckversuch, der mehr als %L1 σ vom Typ entfernt ist, heißt unbekannt (so %2 der eigenen).</translation>
    </message>
    <message>
        <source>Try a squeeze…</source>
        <translation>Druckversuch ausprobieren…</translation>
    </message>
    <message>
        <source>yielding share k1/k</source>
        <translation>nachgebender Anteil k1/k</translation>
    </message>
    <message>
        <source>yields within τ</source>
        <translation>gibt nach in τ</translation>
    </message>
    <message>
        <source>friction Fc</source>
        <translation>Reibung Fc</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollSqueezeModel</name>
    <message>
        <source>stored</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>suspect</source>
        <translation>fraglich</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>%1, accepted</source>
        <translation>%1, zählt</translation>
    </message>
    <message>
        <source>outlier: %1</source>
        <translation>Ausreißer: %1</translation>
    </message>
    <message>
        <source>to decide, an outlier: %1</source>
        <translation>offen, Ausreißer: %1</translation>
    </message>
    <message>
        <source>%1, to decide</source>
        <translation>%1, offen</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation>verworfen: %1</translation>
    </message>
    <message>
        <source>%1
± 95 %</source>
        <translation>%1
± 95 %</translation>
    </message>
    <message>
        <source>%1 (%2)
± 95 %</source>
        <translation>%1 (%2)
± 95 %</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Simulation
fit</source>
        <translation>Simul.-
Fit</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrollSqueezePanel</name>
    <message>
        <source>Arm the gripper</source>
        <translation>Greifer scharf schalten</translation>
    </message>
    <message>
        <source>Squeeze (Space)</source>
        <translation>Drücken (Leertaste)</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>another one each time</source>
        <translation>jedes Mal ein anderes</translation>
    </message>
    <message>
        <source>Which part is squeezed</source>
        <translation>Welches Teil gedrückt wird</translation>
    </message>
    <message>
        <source>Give parts a number or a mark when you squeeze one more than once: the type then knows how much its parts differ, and how much only the grip.</source>
        <translation>Teilen eine Nummer oder ein Zeichen geben, wenn eines mehrmals gedrückt wird: So lernt der Typ, wie sehr sich seine Teile unterscheiden und wie sehr nur der Griff.</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Squeezes of this type</source>
        <translation>Druckversuche dieses Typs</translation>
    </message>
    <message>
        <source>Drop selected…</source>
        <translation>Auswahl verwerfen…</translation>
    </message>
    <message>
        <source>Takes an accepted squeeze out of the type, with a reason; the library keeps both</source>
        <translation>Nimmt einen angenommenen Druckversuch aus dem Typ, mit einem Grund; die Bibliothek behält beides</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsehen</translation>
    </message>
    <message>
        <source>Squeezes of %1</source>
        <translation>Druckversuche von %1</translation>
    </message>
    <message>
        <source>Squeezing…</source>
        <translation>Drückt…</translation>
    </message>
    <message>
        <source>Place a part of this type, hands clear, then arm.</source>
        <translation>Ein Teil dieses Typs einlegen, Hände weg, dann scharf schalten.</translation>
    </message>
    <message>
        <source>Enough squeezes: review them now.</source>
        <translation>Genug Druckversuche: jetzt durchsehen.</translation>
    </message>
    <message>
        <source>Turn or change the part between squeezes, so that the type&apos;s spread is seen.</source>
        <translation>Nach jedem Versuch das Teil drehen oder wechseln.</translation>
    </message>
    <message>
        <source>Drop outlier %1…</source>
        <translation>Ausreißer %1 verwerfen…</translation>
    </message>
    <message>
        <source>A type needs at least %1 accepted squeezes</source>
        <translation>Ein Typ braucht mindestens %1 angenommene Druckversuche</translation>
    </message>
    <message>
        <source>Finding m, b and k…</source>
        <translation>m, b und k werden bestimmt…</translation>
    </message>
    <message>
        <source>No squeeze yet</source>
        <translation>Noch kein Druckversuch</translation>
    </message>
    <message>
        <source>Rejected: %1</source>
        <translation>Verworfen: %1</translation>
    </message>
    <message>
        <source>It does not go with the others. %1 Accept it only if such parts belong to the type.</source>
        <translation>Er passt nicht zu den anderen. %1 Nur annehmen, wenn solche Teile zum Typ gehören.</translation>
    </message>
    <message>
        <source>Accept it (Space) or reject it.</source>
        <translation>Annehmen (Leertaste) oder verwerfen.</translation>
    </message>
    <message>
        <source>Accepted and stored.</source>
        <translation>Angenommen und gespeichert.</translation>
    </message>
    <message>
        <source>by the operator</source>
        <translation>durch den Bediener</translation>
    </message>
    <message>
        <source>Drop squeeze %1</source>
        <translation>Druckversuch %1 verwerfen</translation>
    </message>
    <message>
        <source>Why is squeeze %1 dropped? The reason is kept.</source>
        <translation>Warum wird Druckversuch %1 verworfen? Der Grund wird aufbewahrt.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Accept good squeezes by itself</source>
        <translation>Gute Versuche annehmen</translation>
    </message>
    <message>
        <source>A valid squeeze that goes with the others is accepted without asking; any other waits for you. Ctrl+Z undoes it.</source>
        <translation>Ein gültiger Druckversuch, der zu den anderen passt, wird ohne Nachfrage angenommen; jeder andere wartet. Strg+Z macht es rückgängig.</translation>
    </message>
    <message>
        <source>Squeeze %1, so far</source>
        <translation>Druckversuch %1, bisher</translation>
    </message>
    <message>
        <source>Being accepted…</source>
        <translation>Wird angenommen…</translation>
    </message>
    <message>
        <source>Squeeze %1: %2</source>
        <translation>Druckversuch %1: %2</translation>
    </message>
    <message>
        <source>At least %1 are needed, 4 for the first type of a library; the ring is full when more would gain little.</source>
        <translation>Mindestens %1 sind nötig, 4 beim ersten Typ einer Bibliothek; der Ring ist voll, wenn weitere wenig brächten.</translation>
    </message>
</context>
<context>
    <name>gripscope::EnrolledTypesDialog</name>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Verdicts say the new name from now on. Inspections that were made keep “%1”.</source>
        <translation>Urteile nennen ab jetzt den neuen Namen. Gemachte Prüfungen behalten „%1“.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>New name</source>
        <translation>Neuer Name</translation>
    </message>
    <message>
        <source>Merge %1 into another type</source>
        <translation>%1 mit einem anderen Typ zusammenführen</translation>
    </message>
    <message>
        <source>The %1 squeezes of %2 will count for the other type, and %2 is no longer a type of its own. The other type needs approval again. Merge only types that are squeezed by the same recipe.</source>
        <translation>Die %1 Druckversuche von %2 zählen dann für den anderen Typ, und %2 ist kein eigener Typ mehr. Der andere Typ braucht erneut eine Freigabe. Nur Typen zusammenführen, die mit demselben Rezept gedrückt werden.</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Zusammenführen</translation>
    </message>
    <message>
        <source>The type that stays</source>
        <translation>Der Typ, der bleibt</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 aufteilen</translation>
    </message>
    <message>
        <source>The squeezes that you tick become a new type with the same recipe. Both types then need approval.</source>
        <translation>Die angekreuzten Druckversuche werden ein neuer Typ mit demselben Rezept. Beide Typen brauchen dann eine Freigabe.</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Aufteilen</translation>
    </message>
    <message>
        <source>Name of the new type</source>
        <translation>Name des neuen Typs</translation>
    </message>
    <message>
        <source>Squeezes of the new type</source>
        <translation>Druckversuche des neuen Typs</translation>
    </message>
    <message>
        <source>Retire %1</source>
        <translation>%1 außer Gebrauch nehmen</translation>
    </message>
    <message>
        <source>Parts of %1 are no longer recognised: they will be unknown. Its %2 squeezes are kept, and it can be put back.</source>
        <translation>Teile von %1 werden nicht mehr erkannt: Sie sind dann unbekannt. Die %2 Druckversuche bleiben, und der Typ kann zurückgeholt werden.</translation>
    </message>
    <message>
        <source>Retire</source>
        <translation>Außer Gebrauch nehmen</translation>
    </message>
    <message>
        <source>Put %1 back into use</source>
        <translation>%1 wieder in Gebrauch nehmen</translation>
    </message>
    <message>
        <source>Parts of %1 are recognised again. The type then needs approval.</source>
        <translation>Teile von %1 werden wieder erkannt. Der Typ braucht dann eine Freigabe.</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>%1 changes were made since.</source>
        <translation>%1 Änderungen kamen seither.</translation>
    </message>
    <message>
        <source>Restore version %1</source>
        <translation>Version %1 wiederherstellen</translation>
    </message>
    <message>
        <source>%1 Types and squeezes will again be as they were at version %2. Nothing is deleted: this is a new version, and what was done since can be restored in turn. Inspections are not touched.</source>
        <translation>%1 Typen und Druckversuche werden wieder wie in Version %2. Nichts wird gelöscht: Dies ist eine neue Version, und das seither Getane lässt sich ebenso wiederherstellen. Prüfungen bleiben unberührt.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Enrolled types</source>
        <translation>Eingelernte Typen</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Merge…</source>
        <translation>Zusammenführen…</translation>
    </message>
    <message>
        <source>Split…</source>
        <translation>Aufteilen…</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Retire…</source>
        <translation>Stilllegen…</translation>
    </message>
    <message>
        <source>Put back…</source>
        <translation>Zurückholen…</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Versions of the library</source>
        <translation>Versionen der Bibliothek</translation>
    </message>
    <message>
        <source>Restore this version…</source>
        <translation>Diese Version wiederherstellen…</translation>
    </message>
    <message>
        <source>Undo the last change…</source>
        <translation>Letzte Änderung zurücknehmen…</translation>
    </message>
    <message>
        <source>retired</source>
        <translation>außer Gebrauch</translation>
    </message>
    <message>
        <source>approved</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>not approved</source>
        <translation>nicht freigegeben</translation>
    </message>
    <message>
        <source>Nothing is enrolled yet.</source>
        <translation>Noch ist nichts eingelernt.</translation>
    </message>
    <message>
        <source>Version %1: %2</source>
        <translation>Version %1: %2</translation>
    </message>
    <message>
        <source>Picture of %1</source>
        <translation>Bild von %1</translation>
    </message>
    <message>
        <source>Crush limit</source>
        <translation>Bruchgrenze</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Code of %1</source>
        <translation>Code von %1</translation>
    </message>
    <message>
        <source>What a scanner reads on its parts or on its order: a GTIN, a part number. Scanned on the Inspect page, it makes %1 the expected type. Leave it empty to take the code away.</source>
        <translation>Was ein Scanner auf den Teilen oder dem Auftrag liest: eine GTIN, eine Teilenummer. Auf der Seite Prüfen gescannt, wird %1 der erwartete Typ. Leer lassen, um den Code zu entfernen.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Code, scanned or typed</source>
        <translation>Code, gescannt oder getippt</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Code…</source>
        <translation>Code…</translation>
    </message>
    <message>
        <source>Limits…</source>
        <translation>Toleranzen…</translation>
    </message>
</context>
<context>
    <name>gripscope::EstimateRegion</name>
    <message>
        <source>m, b and k are known almost independently of each other.</source>
        <translation>m, b und k sind fast unabhängig voneinander bekannt.</translation>
    </message>
    <message>
        <source>%1 and %2 err together: if %1 is too high, so is %2.</source>
        <translation>%1 und %2 irren gemeinsam: Ist %1 zu hoch, so auch %2.</translation>
    </message>
    <message>
        <source>%1 and %2 err against each other: if %1 is too high, %2 is too low.</source>
        <translation>%1 und %2 irren gegenläufig: Ist %1 zu hoch, ist %2 zu niedrig.</translation>
    </message>
</context>
<context>
    <name>gripscope::EstimateTableModel</name>
    <message>
        <source>Above: fit of the model running free from the start, 100 (1 - |y - model| / |y - mean|). Below: fit one step ahead from measured positions; says little about m, b and k</source>
        <translation>Oben: Fit des vom Start an frei laufenden Modells, 100 (1 - |y - Modell| / |y - Mittel|). Unten: Fit einen Schritt voraus aus gemessenen Wegen; sagt wenig über m, b und k</translation>
    </message>
    <message>
        <source>Fit one step ahead from measured positions; says little about m, b and k</source>
        <translation>Fit einen Schritt voraus aus gemessenen Wegen; sagt wenig über m, b und k</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>sim. %
pred. %</source>
        <translation>Sim. %
Vorh. %</translation>
    </message>
    <message>
        <source>pred. %</source>
        <translation>Vorh. %</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>gripscope::EstimateWords</name>
    <message>
        <source>did not converge</source>
        <translation>nicht konvergiert</translation>
    </message>
    <message>
        <source>not identifiable</source>
        <translation>nicht bestimmbar</translation>
    </message>
    <message>
        <source>no physical m, b, k</source>
        <translation>m, b, k nicht physikalisch</translation>
    </message>
    <message>
        <source>too few samples</source>
        <translation>zu wenige Abtastwerte</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>nicht anwendbar</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>empfohlen</translation>
    </message>
    <message>
        <source>no comparison</source>
        <translation>kein Vergleich</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>stimmt überein</translation>
    </message>
    <message>
        <source>Lost samples</source>
        <translation>Verlorene Abtastwerte</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Übersteuerung</translation>
    </message>
    <message>
        <source>Excitation</source>
        <translation>Anregung</translation>
    </message>
    <message>
        <source>White residuals</source>
        <translation>Weiße Residuen</translation>
    </message>
    <message>
        <source>Residuals and force</source>
        <translation>Residuen und Kraft</translation>
    </message>
    <message>
        <source>Force between samples</source>
        <translation>Kraftverlauf</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>Physical range</source>
        <translation>Physikalischer Bereich</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Straight spring</source>
        <translation>Gerade Feder</translation>
    </message>
    <message>
        <source>Force feedback</source>
        <translation>Kraftrückkopplung</translation>
    </message>
    <message>
        <source>Recording as such</source>
        <translation>Aufnahme an sich</translation>
    </message>
    <message>
        <source>Steps of the channels</source>
        <translation>Stufen der Kanäle</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>Nicht brauchbar</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Clock drift</source>
        <translation>Uhrdrift</translation>
    </message>
    <message>
        <source>Clock jitter</source>
        <translation>Uhrschwankung</translation>
    </message>
    <message>
        <source>Clock jumps</source>
        <translation>Uhrsprünge</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Contact lost</source>
        <translation>Kontakt verloren</translation>
    </message>
    <message>
        <source>Give of the frame</source>
        <translation>Nachgiebigkeit</translation>
    </message>
    <message>
        <source>Stuck channel</source>
        <translation>Feststeckender Kanal</translation>
    </message>
    <message>
        <source>Gripper&apos;s own fault</source>
        <translation>Eigener Fehler des Greifers</translation>
    </message>
    <message>
        <source>Gripper&apos;s clock</source>
        <translation>Uhr des Greifers</translation>
    </message>
    <message>
        <source>Sample time</source>
        <translation>Abtastzeit</translation>
    </message>
    <message>
        <source>Noise of the force</source>
        <translation>Rauschen der Kraft</translation>
    </message>
    <message>
        <source>Yielding</source>
        <translation>Nachgeben</translation>
    </message>
    <message>
        <source>Position renewed slowly</source>
        <translation>Weg selten erneuert</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Spikes of the force</source>
        <translation>Ausreißer der Kraft</translation>
    </message>
</context>
<context>
    <name>gripscope::EstimatorPanel</name>
    <message>
        <source>Estimators against each other</source>
        <translation>Schätzer im Vergleich</translation>
    </message>
    <message>
        <source>The error bars here are those of noise alone; the intervals above count everything that is known (see Uncertainty).</source>
        <translation>Die Fehlerbalken hier gelten für Rauschen allein; die Intervalle oben zählen alles Bekannte (siehe Unsicherheit).</translation>
    </message>
    <message>
        <source>The table holds what was measured; the empty gripper&apos;s own m, b and k are taken off the numbers above.</source>
        <translation>Die Tabelle enthält das Gemessene; von den Zahlen oben sind m, b und k des leeren Greifers abgezogen.</translation>
    </message>
    <message>
        <source>ARX predicts one step ahead from the last two measured positions. With noise that reads high even when m, b and k are far off: a good ARX prediction fit says nothing about them.</source>
        <translation>ARX sagt aus den letzten zwei gemessenen Wegen einen Schritt voraus. Mit Rauschen ist das auch dann hoch, wenn m, b und k weit danebenliegen: Ein guter Vorhersagefit von ARX sagt nichts über sie.</translation>
    </message>
</context>
<context>
    <name>gripscope::ExampleTypesButton</name>
    <message>
        <source>Load four example types</source>
        <translation>Vier Beispieltypen laden</translation>
    </message>
    <message>
        <source>The four cans of the paper, ten squeezes each; retire them when they are no longer wanted</source>
        <translation>Die vier Dosen der Veröffentlichung mit je zehn Druckversuchen; sie lassen sich außer Gebrauch nehmen</translation>
    </message>
    <message>
        <source>Load plastics, foams and fruit</source>
        <translation>Kunststoffe, Schäume und Obst laden</translation>
    </message>
    <message>
        <source>Six simulated parts that go on yielding, six squeezes each; a virtual gripper can hold them</source>
        <translation>Sechs simulierte Teile, die weiter nachgeben, mit je sechs Druckversuchen; ein virtueller Greifer kann sie halten</translation>
    </message>
</context>
<context>
    <name>gripscope::ExpectationView</name>
    <message>
        <source>Half-widths of 95 % intervals, at best, for %1, %2 and %3 with noise of %4; friction of %5 % of the push and release, and %6 % of k that goes on yielding over %7 % of the length.</source>
        <translation>Halbe Breiten von 95-%-Intervallen, bestenfalls, für %1, %2 und %3 bei einem Rauschen von %4; Reibung von %5 % von Drücken und Nachlassen, und %6 % von k, die über %7 % der Dauer weiter nachgeben.</translation>
    </message>
    <message>
        <source>with friction %1</source>
        <translation>mit Reibung %1</translation>
    </message>
    <message>
        <source>with yielding %1</source>
        <translation>mit Nachgeben %1</translation>
    </message>
    <message>
        <source>At best: %1.</source>
        <translation>Bestenfalls: %1.</translation>
    </message>
</context>
<context>
    <name>gripscope::FitExporter</name>
    <message>
        <source>Everything into a folder…</source>
        <translation>Alles in einen Ordner…</translation>
    </message>
    <message>
        <source>All numbers as JSON…</source>
        <translation>Alle Zahlen als JSON…</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>picture copied</source>
        <translation>Bild kopiert</translation>
    </message>
    <message>
        <source>Save picture as PNG…</source>
        <translation>Bild als PNG speichern…</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Save picture as SVG…</source>
        <translation>Bild als SVG speichern…</translation>
    </message>
    <message>
        <source>SVG (*.svg)</source>
        <translation>SVG (*.svg)</translation>
    </message>
    <message>
        <source>Save data as CSV…</source>
        <translation>Daten als CSV speichern…</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>%1 speichern</translation>
    </message>
    <message>
        <source>Save everything into a folder</source>
        <translation>Alles in einen Ordner speichern</translation>
    </message>
    <message>
        <source>saving…</source>
        <translation>speichert…</translation>
    </message>
    <message>
        <source>saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>saved %n file(s)</source>
        <translation>
            <numerusform>%n Datei gespeichert</numerusform>
            <numerusform>%n Dateien gespeichert</numerusform>
        </translation>
    </message>
    <message>
        <source>Not saved: %1. Choose a folder that you may write to and that has room, then save again.</source>
        <translation>Nicht gespeichert: %1. Einen beschreibbaren Ordner mit genug Platz wählen, dann erneut speichern.</translation>
    </message>
    <message>
        <source>Width of pictures</source>
        <translation>Breite der Bilder</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>One journal column (85 mm)</source>
        <translation>Eine Zeitschriftenspalte (85 mm)</translation>
    </message>
    <message>
        <source>Two journal columns (175 mm)</source>
        <translation>Zwei Zeitschriftenspalten (175 mm)</translation>
    </message>
    <message>
        <source>Picture copied</source>
        <translation>Bild kopiert</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
</context>
<context>
    <name>gripscope::FitPage</name>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
    <message>
        <source>validating…</source>
        <translation>validiert…</translation>
    </message>
    <message>
        <source>Identify again</source>
        <translation>Neu bestimmen</translation>
    </message>
    <message>
        <source>Run every estimator on this squeeze</source>
        <translation>Alle Schätzer auf diesen Druckversuch anwenden</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Zahlen kopieren</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Save plots (PNG, SVG), their data (CSV) and all numbers (JSON)</source>
        <translation>Diagramme (PNG, SVG), ihre Daten (CSV) und alle Zahlen (JSON) speichern</translation>
    </message>
    <message>
        <source>No squeeze to look at yet</source>
        <translation>Noch kein Druckversuch zum Ansehen</translation>
    </message>
    <message>
        <source>copied</source>
        <translation>kopiert</translation>
    </message>
    <message>
        <source>Simulated squeeze of can A</source>
        <translation>Simulierter Druckversuch von Dose A</translation>
    </message>
    <message>
        <source>Inspection %1</source>
        <translation>Prüfung %1</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>Copy the results rounded for a text, for LaTeX or as a table, or every number</source>
        <translation>Die Ergebnisse kopieren, gerundet für einen Text, für LaTeX oder als Tabelle, oder alle Zahlen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>identifying… %1 %</source>
        <translation>identifiziert… %1 %</translation>
    </message>
    <message>
        <source>Results, rounded (± 95 %)</source>
        <translation>Ergebnisse, gerundet (± 95 %)</translation>
    </message>
    <message>
        <source>Results for LaTeX (± 95 %)</source>
        <translation>Ergebnisse für LaTeX (± 95 %)</translation>
    </message>
    <message>
        <source>Results as CSV, all digits</source>
        <translation>Ergebnisse als CSV, alle Stellen</translation>
    </message>
    <message>
        <source>Every number, all digits</source>
        <translation>Alle Zahlen, alle Stellen</translation>
    </message>
    <message>
        <source>Bode</source>
        <translation>Bode</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Bode-Diagramm</translation>
    </message>
    <message>
        <source>Magnitude and phase of measurement and model over frequency</source>
        <translation>Amplitude und Phase von Messung und Modell über der Frequenz</translation>
    </message>
    <message>
        <source>Back to Types (Alt+Left)</source>
        <translation>Zurück zu den Typen (Alt+Pfeil links)</translation>
    </message>
    <message>
        <source>Back to Inspect (Alt+Left)</source>
        <translation>Zurück zu Prüfen (Alt+Pfeil links)</translation>
    </message>
    <message>
        <source>Back to History (Alt+Left)</source>
        <translation>Zurück zum Verlauf (Alt+Pfeil links)</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Read recordings (CSV) and identify them</source>
        <translation>Aufnahmen (CSV) lesen und bestimmen</translation>
    </message>
    <message>
        <source>Squeeze a part on Inspect, double-click a row in History, or open recordings (CSV): drop the files here or press Open.</source>
        <translation>Auf der Seite Prüfen ein Teil drücken, im Verlauf eine Zeile doppelklicken oder Aufnahmen (CSV) öffnen: die Dateien hier ablegen oder „Öffnen“ drücken.</translation>
    </message>
</context>
<context>
    <name>gripscope::FitPlots</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Lag (ms)</source>
        <translation>Versatz (ms)</translation>
    </message>
    <message>
        <source>Residual autocorrelation</source>
        <translation>Autokorrelation der Residuen</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorrelation</translation>
    </message>
    <message>
        <source>Residuals against force</source>
        <translation>Residuen gegen Kraft</translation>
    </message>
    <message>
        <source>Against force</source>
        <translation>Gegen Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Measured position</source>
        <translation>Gemessener Weg</translation>
    </message>
    <message>
        <source>model, %1</source>
        <translation>Modell, %1</translation>
    </message>
    <message>
        <source>Model, %1</source>
        <translation>Modell, %1</translation>
    </message>
    <message>
        <source>Residuals, one step ahead</source>
        <translation>Residuen, einen Schritt voraus</translation>
    </message>
    <message>
        <source>no model, no residuals</source>
        <translation>ohne Modell keine Residuen</translation>
    </message>
    <message>
        <source>± 2 sd</source>
        <translation>± 2 σ</translation>
    </message>
</context>
<context>
    <name>gripscope::FitSummary</name>
    <message>
        <source>Details of the fit</source>
        <translation>Einzelheiten des Fits</translation>
    </message>
    <message>
        <source>Estimators</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfpunkte</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>force held</source>
        <translation>Kraft gehalten</translation>
    </message>
    <message>
        <source>force linear</source>
        <translation>Kraft linear</translation>
    </message>
    <message>
        <source>Checks (%1)</source>
        <translation>Prüfpunkte (%1)</translation>
    </message>
    <message>
        <source>No estimate</source>
        <translation>Keine Schätzung</translation>
    </message>
    <message>
        <source>length %1 · %2 samples · %3 between samples</source>
        <translation>Dauer %1 · %2 Abtastwerte · %3 dazwischen</translation>
    </message>
</context>
<context>
    <name>gripscope::ForceLevelsRow</name>
    <message>
        <source>From a file…</source>
        <translation>Aus Datei…</translation>
    </message>
    <message>
        <source>Optimise</source>
        <translation>Optimieren</translation>
    </message>
    <message>
        <source>A table with a column &quot;force&quot; in newtons and the times of its rows (time_s), such as a recording</source>
        <translation>Eine Tabelle mit einer Spalte „force“ in Newton und den Zeiten ihrer Zeilen (time_s), etwa eine Aufnahme</translation>
    </message>
    <message>
        <source>Searches the two-level force that tells the enrolled types apart best, within these forces and times</source>
        <translation>Sucht innerhalb dieser Kräfte und Zeiten die Kraft aus zwei Stufen, die die eingelernten Typen am besten unterscheidet</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Noch keine.</translation>
    </message>
    <message>
        <source>%1 levels of %2 ms.</source>
        <translation>%1 Stufen zu %2 ms.</translation>
    </message>
    <message>
        <source>A force to squeeze with</source>
        <translation>Eine Kraft zum Drücken</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tabellen (*.csv *.txt);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>gripscope::ForcePicture</name>
    <message>
        <source>Picture of the force</source>
        <translation>Bild der Kraft</translation>
    </message>
</context>
<context>
    <name>gripscope::ForeignTableDialog</name>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Import a table</source>
        <translation>Tabelle importieren</translation>
    </message>
    <message>
        <source>%1 was written by another program. Say what in it is what; for tables of this layout it is remembered.</source>
        <translation>%1 stammt von einem anderen Programm. Angeben, was darin was ist; für Tabellen mit diesem Aufbau bleibt es gespeichert.</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>Semikolon</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>point: 1.5</source>
        <translation>Punkt: 1.5</translation>
    </message>
    <message>
        <source>comma: 1,5</source>
        <translation>Komma: 1,5</translation>
    </message>
    <message>
        <source>a line of names</source>
        <translation>eine Kopfzeile</translation>
    </message>
    <message>
        <source>Between fields</source>
        <translation>Zwischen den Feldern</translation>
    </message>
    <message>
        <source>Decimal mark</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>Lines to skip before</source>
        <translation>Zeilen davor überspringen</translation>
    </message>
    <message>
        <source>The table has</source>
        <translation>Die Tabelle hat</translation>
    </message>
    <message>
        <source>Lines below the names</source>
        <translation>Zeilen unter der Kopfzeile</translation>
    </message>
    <message>
        <source>held (zoh)</source>
        <translation>gehalten (zoh)</translation>
    </message>
    <message>
        <source>straight line (foh)</source>
        <translation>gerade (foh)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Force between samples</source>
        <translation>Kraft zwischen den Abtastwerten</translation>
    </message>
    <message>
        <source>Unit of time</source>
        <translation>Einheit der Zeit</translation>
    </message>
    <message>
        <source>Unit of force</source>
        <translation>Einheit der Kraft</translation>
    </message>
    <message>
        <source>Unit of position</source>
        <translation>Einheit des Wegs</translation>
    </message>
    <message>
        <source>Sample time (ms)</source>
        <translation>Abtastzeit (ms)</translation>
    </message>
    <message>
        <source>First rows</source>
        <translation>Erste Zeilen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>no column</source>
        <translation>keine Spalte</translation>
    </message>
    <message>
        <source>There are no two columns of numbers in it so.</source>
        <translation>So sind darin keine zwei Spalten mit Zahlen.</translation>
    </message>
    <message>
        <source>The first row is read as force %1, position %2. Sample time %3 ms.</source>
        <translation>Die erste Zeile wird gelesen als Kraft %1, Weg %2. Abtastzeit %3 ms.</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
</context>
<context>
    <name>gripscope::FrameStep</name>
    <message>
        <source>Squeeze the block (Space)</source>
        <translation>Den Block drücken (Leertaste)</translation>
    </message>
    <message>
        <source>Measure again (Space)</source>
        <translation>Neu messen (Leertaste)</translation>
    </message>
    <message>
        <source>Take it off from now on</source>
        <translation>Ab jetzt abziehen</translation>
    </message>
    <message numerus="yes">
        <source>Frame and fingers give way, which the position counts as the part&apos;s. Put in a steel block, which does not: it is squeezed %n times, with the force of the parts.</source>
        <translation>
            <numerusform>Gestell und Finger geben nach, was der Weg dem Teil zurechnet. Einen Stahlblock einlegen, der nicht nachgibt: Er wird %n-mal gedrückt, mit der Kraft der Teile.</numerusform>
            <numerusform>Gestell und Finger geben nach, was der Weg dem Teil zurechnet. Einen Stahlblock einlegen, der nicht nachgibt: Er wird %n-mal gedrückt, mit der Kraft der Teile.</numerusform>
        </translation>
    </message>
    <message>
        <source>k %1</source>
        <translation>k %1</translation>
    </message>
    <message>
        <source>In use for gripper %1: the frame has %2.</source>
        <translation>In Gebrauch für Greifer %1: Das Gestell hat %2.</translation>
    </message>
    <message>
        <source>The frame has %1 (95 %).</source>
        <translation>Das Gestell hat %1 (95 %).</translation>
    </message>
</context>
<context>
    <name>gripscope::FrequencyPlot</name>
    <message>
        <source>Frequency (Hz)</source>
        <translation>Frequenz (Hz)</translation>
    </message>
    <message>
        <source>from, 95 %</source>
        <translation>von, 95 %</translation>
    </message>
    <message>
        <source>to, 95 %</source>
        <translation>bis, 95 %</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1, gemessen</translation>
    </message>
    <message>
        <source>%1, measured, coherence too low</source>
        <translation>%1, gemessen, Kohärenz zu klein</translation>
    </message>
    <message>
        <source>%1, model</source>
        <translation>%1, Modell</translation>
    </message>
</context>
<context>
    <name>gripscope::GripperStep</name>
    <message>
        <source>Change the forces above first.</source>
        <translation>Erst die Kräfte oben ändern.</translation>
    </message>
    <message>
        <source>Not valid, so nothing changes: %1</source>
        <translation>Ungültig, also ändert sich nichts: %1</translation>
    </message>
</context>
<context>
    <name>gripscope::GuidedSqueezes</name>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>No gripper is connected. Choose one at the top.</source>
        <translation>Kein Greifer ist verbunden. Oben einen wählen.</translation>
    </message>
    <message>
        <source>This gripper only streams, so that it cannot be measured from here.</source>
        <translation>Dieser Greifer sendet nur und lässt sich von hier nicht messen.</translation>
    </message>
    <message>
        <source>Hands clear, then arm.</source>
        <translation>Hände weg, dann scharf schalten.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
</context>
<context>
    <name>gripscope::HeaderBar</name>
    <message>
        <source>Arm</source>
        <translation>Schärfen</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Armed; press to disarm</source>
        <translation>Scharf; drücken zum Entschärfen</translation>
    </message>
    <message>
        <source>Arm the gripper</source>
        <translation>Den Greifer scharf schalten</translation>
    </message>
    <message>
        <source>The gripper may move. Press to disarm it.</source>
        <translation>Der Greifer darf sich bewegen. Drücken zum Entschärfen.</translation>
    </message>
    <message>
        <source>No gripper that can be commanded is connected</source>
        <translation>Kein steuerbarer Greifer ist verbunden</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Hold…</source>
        <translation>Halten…</translation>
    </message>
    <message>
        <source>Let the gripper move when a squeeze is asked for. By keys: hold Ctrl+Shift+A for a second</source>
        <translation>Den Greifer sich bewegen lassen, wenn ein Druckversuch verlangt wird. Mit Tasten: Strg+Umschalt+A eine Sekunde lang halten</translation>
    </message>
    <message>
        <source>loses %1</source>
        <translation>verliert %1</translation>
    </message>
</context>
<context>
    <name>gripscope::HeatMap</name>
    <message>
        <source>%1 From %2 to %3.</source>
        <translation>%1 Von %2 bis %3.</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Druckversuche</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Gruppe</translation>
    </message>
</context>
<context>
    <name>gripscope::HistogramPlot</name>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryCharts</name>
    <message>
        <source>Over time</source>
        <translation>Über der Zeit</translation>
    </message>
    <message>
        <source>One after another</source>
        <translation>Der Reihe nach</translation>
    </message>
    <message>
        <source>Bands: where 95 % of the squeezes of an enrolled type lie. Bars: 95 % intervals of the squeeze. Drag to zoom, double click to see everything.</source>
        <translation>Bänder: wo 95 % der Druckversuche eines eingelernten Typs liegen. Balken: 95-%-Intervalle des Druckversuchs. Ziehen zum Vergrößern, Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>One inspection in %1 is drawn, by its number: a single outlier may be missing. Narrow the dates to see every one.</source>
        <translation>Nach der Nummer ist eine von %1 Prüfungen gezeichnet: Ein einzelner Ausreißer kann fehlen. Um jede zu sehen, die Tage eingrenzen.</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryDetails</name>
    <message>
        <source>The squeeze that is chosen</source>
        <translation>Der gewählte Druckversuch</translation>
    </message>
    <message>
        <source>Choose a squeeze to see all that is known of it.</source>
        <translation>Einen Druckversuch wählen, um alles über ihn zu sehen.</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>Woher er kommt</translation>
    </message>
    <message>
        <source>Identified again: %1</source>
        <translation>Neu identifiziert: %1</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>The verdict stays the one of its day; later estimates stand beside it.</source>
        <translation>Das Urteil bleibt das seines Tages; spätere Schätzungen stehen daneben.</translation>
    </message>
    <message>
        <source>%1, %2, %3 %</source>
        <translation>%1, %2, %3 %</translation>
    </message>
    <message>
        <source>Uncertainty of m, b, k comes from</source>
        <translation>Unsicherheit von m, b, k kommt von</translation>
    </message>
    <message>
        <source>Simulation fit</source>
        <translation>Simulationsfit</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryFilterBar</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the history</source>
        <translation>Den Verlauf durchsuchen</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>Inspected or enrolled</source>
        <translation>Geprüft oder eingelernt</translation>
    </message>
    <message>
        <source>Inspections</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Enrolments</source>
        <translation>Einlernungen</translation>
    </message>
    <message>
        <source>All outcomes</source>
        <translation>Alle Ergebnisse</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>All types</source>
        <translation>Alle Typen</translation>
    </message>
    <message>
        <source>Type named, or enrolled in</source>
        <translation>Benannter oder eingelernter Typ</translation>
    </message>
    <message>
        <source>More filters</source>
        <translation>Mehr Filter</translation>
    </message>
    <message>
        <source>Any expected</source>
        <translation>Jeder erwartete</translation>
    </message>
    <message>
        <source>Expected type</source>
        <translation>Erwarteter Typ</translation>
    </message>
    <message>
        <source>All operators</source>
        <translation>Alle Bediener</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>All grippers</source>
        <translation>Alle Greifer</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Jederzeit</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>From … to …</source>
        <translation>Von … bis …</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Erster Tag</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Letzter Tag</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>More filters (%1)</source>
        <translation>Mehr Filter (%1)</translation>
    </message>
    <message>
        <source>In number, type, operator, gripper, batch, source or part</source>
        <translation>In Nummer, Typ, Bediener, Greifer, Los, Quelle oder Teil</translation>
    </message>
    <message>
        <source>All batches</source>
        <translation>Alle Lose</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>Any validity</source>
        <translation>Jede Gültigkeit</translation>
    </message>
    <message>
        <source>Validity of the measurement</source>
        <translation>Gültigkeit der Messung</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryModel</name>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryPage</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Open in Fit</source>
        <translation>Im Fit öffnen</translation>
    </message>
    <message>
        <source>Nothing matches the filters</source>
        <translation>Nichts passt zu den Filtern</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Identify the recording of the chosen squeeze again and look at it (Enter)</source>
        <translation>Die Aufnahme des gewählten Druckversuchs neu identifizieren und ansehen (Eingabetaste)</translation>
    </message>
    <message>
        <source>Identify again…</source>
        <translation>Neu bestimmen…</translation>
    </message>
    <message>
        <source>The selected squeezes with another estimator</source>
        <translation>Die gewählten Druckversuche mit einem anderen Schätzer</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>All that is listed, as CSV…</source>
        <translation>Alles Gelistete als CSV…</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Als CSV exportieren</translation>
    </message>
    <message>
        <source>All that is listed, as JSON…</source>
        <translation>Alles Gelistete als JSON…</translation>
    </message>
    <message>
        <source>Export as JSON</source>
        <translation>Als JSON exportieren</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Report as PDF…</source>
        <translation>Bericht als PDF…</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Recordings of the selected squeezes…</source>
        <translation>Aufnahmen der gewählten Druckversuche…</translation>
    </message>
    <message>
        <source>No squeezes yet</source>
        <translation>Noch keine Druckversuche</translation>
    </message>
    <message>
        <source>Squeeze a part on the Inspect page, or enroll a type: every squeeze is kept here.</source>
        <translation>Auf der Seite Prüfen ein Teil drücken oder einen Typ einlernen: Jeder Druckversuch wird hier aufbewahrt.</translation>
    </message>
    <message>
        <source>Clear the search and the filters to see every squeeze.</source>
        <translation>Suche und Filter leeren, um alle Druckversuche zu sehen.</translation>
    </message>
    <message>
        <source>Folder for the recordings</source>
        <translation>Ordner für die Aufnahmen</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Squeezes written to %1</source>
        <translation>Druckversuche nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Writing recordings</source>
        <translation>Aufnahmen werden geschrieben</translation>
    </message>
    <message>
        <source>Recordings written to %1</source>
        <translation>Aufnahmen nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagern</translation>
    </message>
    <message>
        <source>Force and position of the selected squeezes over each other</source>
        <translation>Kraft und Weg der gewählten Druckversuche übereinander</translation>
    </message>
    <message>
        <source>Squeeze %1</source>
        <translation>Druckversuch %1</translation>
    </message>
    <message>
        <source>More than %1 squeezes are selected. Select fewer, and the others after them.</source>
        <translation>Mehr als %1 Druckversuche sind ausgewählt. Weniger auswählen, die übrigen danach.</translation>
    </message>
    <message>
        <source>Counting: %1 so far</source>
        <translation>Wird gezählt: bisher %1</translation>
    </message>
    <message>
        <source>Sorted: only the oldest %1</source>
        <translation>Sortiert: nur die ältesten %1</translation>
    </message>
    <message>
        <source>Sorted: only the newest %1</source>
        <translation>Sortiert: nur die neuesten %1</translation>
    </message>
    <message>
        <source>All that is listed, for Q-DAS…</source>
        <translation>Alles Gelistete für Q-DAS…</translation>
    </message>
    <message>
        <source>Export for Q-DAS</source>
        <translation>Für Q-DAS exportieren</translation>
    </message>
    <message>
        <source>AQDEF (*.dfq)</source>
        <translation>AQDEF (*.dfq)</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryReport</name>
    <message>
        <source>%1 of %2 (%3); with 95 % confidence each at least %4, at most %5</source>
        <translation>%1 von %2 (%3); mit je 95 % Vertrauen mindestens %4, höchstens %5</translation>
    </message>
    <message>
        <source>Inspected</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>As expected</source>
        <translation>Wie erwartet</translation>
    </message>
    <message>
        <source>Other type</source>
        <translation>Anderer Typ</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>Eingelernt</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Von, bis</translation>
    </message>
    <message>
        <source>not named</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>Types as they are enrolled</source>
        <translation>Typen, wie sie eingelernt sind</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>95 % of squeezes</source>
        <translation>95 % der Druckversuche</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Report of squeezes</source>
        <translation>Bericht über Druckversuche</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Zählungen</translation>
    </message>
    <message>
        <source>Who and with what</source>
        <translation>Wer und womit</translation>
    </message>
    <message>
        <source>Made %1 by %2 with Gripscope %3 from %4. Each squeeze keeps the version it was identified with.</source>
        <translation>Erstellt am %1 von %2 mit Gripscope %3 aus %4. Jeder Druckversuch behält die Version, mit der er identifiziert wurde.</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>jemand Ungenanntem</translation>
    </message>
    <message>
        <source>m, b and k over time</source>
        <translation>m, b und k über der Zeit</translation>
    </message>
    <message>
        <source>The first %1 of %2; an export as CSV or JSON holds all.</source>
        <translation>Die ersten %1 von %2; ein Export als CSV oder JSON enthält alle.</translation>
    </message>
    <message>
        <source>Yield</source>
        <translation>Ausbeute</translation>
    </message>
    <message>
        <source>Inconclusive, not judged</source>
        <translation>Unentschieden, nicht beurteilt</translation>
    </message>
    <message>
        <source>Measurement not valid, not judged</source>
        <translation>Messung ungültig, nicht beurteilt</translation>
    </message>
    <message>
        <source>Measurement suspect</source>
        <translation>Messung fraglich</translation>
    </message>
    <message>
        <source>Rates then</source>
        <translation>Fehlerraten damals</translation>
    </message>
    <message>
        <source>version %1 of the library</source>
        <translation>Version %1 der Bibliothek</translation>
    </message>
    <message>
        <source>versions %1 to %2 of the library</source>
        <translation>Versionen %1 bis %2 der Bibliothek</translation>
    </message>
    <message>
        <source>Types then</source>
        <translation>Typen damals</translation>
    </message>
    <message>
        <source>Judged by Gripscope</source>
        <translation>Beurteilt mit Gripscope</translation>
    </message>
    <message>
        <source>Force, calibration then</source>
        <translation>Kraft, Kalibrierung damals</translation>
    </message>
    <message>
        <source>Position, calibration then</source>
        <translation>Weg, Kalibrierung damals</translation>
    </message>
    <message>
        <source>Known type, none expected</source>
        <translation>Bekannter Typ, keiner erwartet</translation>
    </message>
    <message>
        <source>One inspection in %1 is drawn, by its number.</source>
        <translation>Nach der Nummer ist eine von %1 Prüfungen gezeichnet.</translation>
    </message>
    <message>
        <source>Voided, counted in none of these</source>
        <translation>Storniert, in keiner dieser Zahlen</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>Part number</source>
        <translation>Teilenummer</translation>
    </message>
    <message>
        <source>Report of squeezes no. %1</source>
        <translation>Bericht über Druckversuche Nr. %1</translation>
    </message>
    <message>
        <source>Its number is that of its entry in the audit trail.</source>
        <translation>Seine Nummer ist die seines Eintrags im Änderungsprotokoll.</translation>
    </message>
    <message>
        <source>Does not conform to its limits</source>
        <translation>Nicht konform zu den Toleranzgrenzen</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryTable</name>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryWords</name>
    <message>
        <source>inspection</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>enrolment</source>
        <translation>Einlernung</translation>
    </message>
    <message>
        <source>Inspection %1</source>
        <translation>Prüfung %1</translation>
    </message>
    <message>
        <source>%1, part %2</source>
        <translation>%1, Teil %2</translation>
    </message>
    <message>
        <source>%1, enrolled %2</source>
        <translation>%1, Einlernung %2</translation>
    </message>
    <message>
        <source>hold as recorded</source>
        <translation>Kraftverlauf wie aufgenommen</translation>
    </message>
    <message>
        <source>force held between samples</source>
        <translation>Kraft gehalten</translation>
    </message>
    <message>
        <source>force straight between samples</source>
        <translation>Kraft gerade</translation>
    </message>
    <message>
        <source>free start</source>
        <translation>freier Anfang</translation>
    </message>
    <message>
        <source>starts at rest</source>
        <translation>beginnt in Ruhe</translation>
    </message>
    <message>
        <source>free offset</source>
        <translation>freier Nullpunkt</translation>
    </message>
    <message>
        <source>no offset</source>
        <translation>kein Nullpunkt</translation>
    </message>
    <message>
        <source>%1 inspected</source>
        <translation>%1 geprüft</translation>
    </message>
    <message>
        <source>%1 other type</source>
        <translation>%1 anderer Typ</translation>
    </message>
    <message>
        <source>%1 unknown</source>
        <translation>%1 unbekannt</translation>
    </message>
    <message>
        <source>%1 inconclusive</source>
        <translation>%1 unentschieden</translation>
    </message>
    <message>
        <source>%1 not valid</source>
        <translation>%1 ungültig</translation>
    </message>
    <message>
        <source>%1 enrolled</source>
        <translation>%1 eingelernt</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>enrolment, dropped</source>
        <translation>Einlernung, verworfen</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Wahrsch.</translation>
    </message>
    <message>
        <source>Distance, gate</source>
        <translation>Abstand, Grenze</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Fehlerraten</translation>
    </message>
    <message>
        <source>false reject %1, wrong type %2</source>
        <translation>Fehlrückweisung %1, Verwechslung %2</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Calibration, %1</source>
        <translation>Kalibrierung, %1</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>voided: %1</source>
        <translation>storniert: %1</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>suspect</source>
        <translation>fraglich</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>stranger-accept, confidence and robust gates not recorded</source>
        <translation>Fremdannahme, Vertrauen und robuste Grenzen nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>stranger accept %1</source>
        <translation>Fremdannahme %1</translation>
    </message>
    <message>
        <source>for this library with %1 confidence</source>
        <translation>für diese Bibliothek mit %1 Vertrauen</translation>
    </message>
    <message>
        <source>on average over libraries</source>
        <translation>im Mittel über Bibliotheken</translation>
    </message>
    <message>
        <source>robust gates</source>
        <translation>robuste Grenzen</translation>
    </message>
    <message>
        <source>not calibrated: the gripper&apos;s own scale was taken</source>
        <translation>nicht kalibriert: Es galt die eigene Skala des Greifers</translation>
    </message>
    <message>
        <source>%1 suspect</source>
        <translation>%1 fraglich</translation>
    </message>
    <message>
        <source>%1 voided</source>
        <translation>%1 storniert</translation>
    </message>
    <message>
        <source>Validity</source>
        <translation>Gültigkeit</translation>
    </message>
    <message>
        <source>Part number</source>
        <translation>Teilenummer</translation>
    </message>
    <message>
        <source>Voided, does not count</source>
        <translation>Storniert, zählt nicht</translation>
    </message>
    <message>
        <source>%1 sd, %2 sd</source>
        <translation>%1 σ, %2 σ</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>version %1 of the library</source>
        <translation>Version %1 der Bibliothek</translation>
    </message>
    <message>
        <source>version of the library not recorded</source>
        <translation>Version der Bibliothek nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>The station&apos;s clock was set back from %1 to %2: this time may be wrong.</source>
        <translation>Die Uhr der Station wurde von %1 auf %2 zurückgestellt: Diese Zeit ist womöglich falsch.</translation>
    </message>
    <message>
        <source>Tolerance limits</source>
        <translation>Toleranzgrenzen</translation>
    </message>
    <message>
        <source>%1 not conforming</source>
        <translation>%1 nicht konform</translation>
    </message>
</context>
<context>
    <name>gripscope::HistoryWork</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Bericht nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>gripscope::ImportDialog</name>
    <message>
        <source>The file has values that cannot be used, so nothing of it is taken.</source>
        <translation>Die Datei hat unbrauchbare Werte, also wird nichts von ihr übernommen.</translation>
    </message>
    <message>
        <source>The file changes nothing: all settings are as they are in it.</source>
        <translation>Die Datei ändert nichts: Alle Einstellungen sind schon wie in ihr.</translation>
    </message>
    <message>
        <source>These settings change:</source>
        <translation>Diese Einstellungen ändern sich:</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Einstellungen importieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Was sich ändert</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>From the file</source>
        <translation>Aus der Datei</translation>
    </message>
</context>
<context>
    <name>gripscope::ImprovementAdvice</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>The lag between the channels dominates the error of %1: measure the lag.</source>
        <translation>Der Zeitversatz der Kanäle bestimmt den Fehler von %1: den Zeitversatz messen.</translation>
    </message>
    <message>
        <source>How the force runs between samples dominates the error of %1: sample faster, or name the force hold of the device.</source>
        <translation>Der Kraftverlauf zwischen den Abtastwerten bestimmt den Fehler von %1: schneller abtasten oder den Kraftverlauf des Geräts angeben.</translation>
    </message>
    <message>
        <source>The calibration dominates the error of %1: calibrate force and position anew.</source>
        <translation>Die Kalibrierung bestimmt den Fehler von %1: Kraft und Weg neu kalibrieren.</translation>
    </message>
    <message>
        <source>The force calibration dominates the error of %1: calibrate the force with better weights.</source>
        <translation>Die Kraftkalibrierung bestimmt den Fehler von %1: die Kraft mit besseren Gewichten kalibrieren.</translation>
    </message>
    <message>
        <source>The position calibration dominates the error of %1: calibrate the position with better gauge blocks.</source>
        <translation>Die Wegkalibrierung bestimmt den Fehler von %1: den Weg mit besseren Endmaßen kalibrieren.</translation>
    </message>
    <message>
        <source>The give of the frame dominates the error of %1: measure it with a rigid block.</source>
        <translation>Die Nachgiebigkeit des Gestells bestimmt den Fehler von %1: mit einem starren Block messen.</translation>
    </message>
    <message>
        <source>The empty gripper dominates the error of %1: measure it again, for longer.</source>
        <translation>Der leere Greifer bestimmt den Fehler von %1: ihn noch einmal und länger messen.</translation>
    </message>
    <message>
        <source>Parts of this squeeze disagree about %1: squeeze with the amplitude that matters to you, or look at the models.</source>
        <translation>Abschnitte dieses Druckversuchs sind sich über %1 uneins: mit der Amplitude drücken, auf die es ankommt, oder die Modelle ansehen.</translation>
    </message>
    <message>
        <source>Noise dominates the error of %1: squeeze 4 times longer to halve it.</source>
        <translation>Rauschen bestimmt den Fehler von %1: 4-mal so lang drücken, um ihn zu halbieren.</translation>
    </message>
    <message>
        <source>Noise makes most of the error of %1: squeeze 4 times longer to halve that part.</source>
        <translation>Rauschen macht den größten Teil des Fehlers von %1 aus: 4-mal so lang drücken, um diesen Teil zu halbieren.</translation>
    </message>
    <message>
        <source>%1 is known %2 times worse than %3</source>
        <translation>%1 ist %2-mal schlechter bekannt als %3</translation>
    </message>
    <message>
        <source>%1: a force that changes faster (shorter bits) says more about m.</source>
        <translation>%1: Eine schneller wechselnde Kraft (kürzere Bits) sagt mehr über m.</translation>
    </message>
    <message>
        <source>%1: a force that is stronger around %2 Hz says more about b.</source>
        <translation>%1: Eine um %L2 Hz stärkere Kraft sagt mehr über b.</translation>
    </message>
    <message>
        <source>%1: a force that changes more slowly (longer bits) says more about k.</source>
        <translation>%1: Eine langsamer wechselnde Kraft (längere Bits) sagt mehr über k.</translation>
    </message>
    <message>
        <source>Little is left to gain: m, b and k are known to %1 % or better.</source>
        <translation>Wenig ist noch zu gewinnen: m, b und k sind auf %L1 % oder besser bekannt.</translation>
    </message>
    <message>
        <source>No single effect dominates: the budget shows what to gain where.</source>
        <translation>Kein einzelner Einfluss herrscht vor: Das Budget zeigt, was wo zu gewinnen ist.</translation>
    </message>
    <message>
        <source>What is left is more than noise: a longer squeeze will not help before the model fits. Compare the models.</source>
        <translation>Der Rest ist mehr als Rauschen: Länger drücken hilft erst, wenn das Modell passt. Die Modelle vergleichen.</translation>
    </message>
    <message>
        <source>The steps of the position dominate the error of %1: squeeze with more force, or measure the position in finer steps.</source>
        <translation>Die Stufen des Wegs bestimmen den Fehler von %1: mit mehr Kraft drücken oder den Weg feiner auflösen.</translation>
    </message>
    <message>
        <source>Samples beside their times dominate the error of %1: steady the gripper&apos;s clock.</source>
        <translation>Abtastwerte neben ihren Zeiten überwiegen beim Fehler von %1: den Takt des Greifers beruhigen.</translation>
    </message>
    <message>
        <source>Friction that may hide in this squeeze dominates the error of %1: four levels of force tell it (the recipe on Enroll; gripscope-cli record --excitation four-level).</source>
        <translation>Reibung, die sich in diesem Druckversuch verbergen kann, überwiegt beim Fehler von %1: Vier Kraftstufen trennen sie ab (das Rezept auf Einlernen; gripscope-cli record --excitation four-level).</translation>
    </message>
</context>
<context>
    <name>gripscope::InspectAutomatic</name>
    <message>
        <source>Squeezes in %1 s</source>
        <translation>Drückt in %1 s</translation>
    </message>
    <message>
        <source>Take the hand away or press Stop.</source>
        <translation>Hand wegnehmen oder STOPP drücken.</translation>
    </message>
    <message>
        <source>Squeezes by itself when a part arrives, once the gripper is armed</source>
        <translation>Drückt von selbst, wenn ein Teil kommt, sobald der Greifer scharf ist</translation>
    </message>
    <message>
        <source>Stopped: squeezes by itself again once you have armed the gripper or squeezed</source>
        <translation>Angehalten: drückt erst wieder von selbst nach Scharfschalten oder Drücken von Hand</translation>
    </message>
    <message>
        <source>Learns the force at rest: keep the jaws empty for a second</source>
        <translation>Lernt die Kraft in Ruhe: Backen eine Sekunde leer lassen</translation>
    </message>
    <message>
        <source>Squeezes by itself %1 s after a part has arrived</source>
        <translation>Drückt von selbst, %1 s nachdem ein Teil gekommen ist</translation>
    </message>
    <message>
        <source>A part has arrived: the force is to keep still</source>
        <translation>Ein Teil ist da: Die Kraft muss ruhig sein</translation>
    </message>
    <message>
        <source>A key, a click or any change of the force ends it</source>
        <translation>Eine Taste, ein Klick oder jede Änderung der Kraft bricht ab</translation>
    </message>
    <message>
        <source>Take the part out: the next one that arrives is squeezed by itself</source>
        <translation>Teil herausnehmen: Das nächste, das kommt, wird von selbst gedrückt</translation>
    </message>
</context>
<context>
    <name>gripscope::InspectBatch</name>
    <message>
        <source>Progress of the batch</source>
        <translation>Fortschritt des Loses</translation>
    </message>
    <message>
        <source>End…</source>
        <translation>Ende…</translation>
    </message>
    <message>
        <source>End the batch</source>
        <translation>Los beenden</translation>
    </message>
    <message>
        <source>Begin a batch…</source>
        <translation>Los beginnen…</translation>
    </message>
    <message>
        <source>Batch %1 is complete</source>
        <translation>Los %1 ist vollständig</translation>
    </message>
    <message>
        <source>Batch %1 was ended</source>
        <translation>Los %1 wurde beendet</translation>
    </message>
    <message>
        <source>Batch %1</source>
        <translation>Los %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>End batch %1 at %2 of %3?</source>
        <translation>Los %1 bei %2 von %3 beenden?</translation>
    </message>
    <message>
        <source>What was inspected is kept. A batch that was ended cannot go on.</source>
        <translation>Das Geprüfte bleibt erhalten. Ein beendetes Los kann nicht weitergehen.</translation>
    </message>
    <message>
        <source>End it</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Go on inspecting</source>
        <translation>Weiter prüfen</translation>
    </message>
</context>
<context>
    <name>gripscope::InspectMeasurement</name>
    <message>
        <source>stiffness k (95 %)</source>
        <translation>Steifigkeit k (95 %)</translation>
    </message>
    <message>
        <source>damping b (95 %)</source>
        <translation>Dämpfung b (95 %)</translation>
    </message>
    <message>
        <source>moving mass m (95 %)</source>
        <translation>bewegte Masse m (95 %)</translation>
    </message>
    <message>
        <source>This says nothing about the part: it is neither good nor bad. The squeeze is kept under its number, but counts neither in the yield nor towards the batch.</source>
        <translation>Das sagt nichts über das Teil: Es ist weder gut noch schlecht. Der Druckversuch bleibt unter seiner Nummer erhalten, zählt aber weder zur Ausbeute noch zum Los.</translation>
    </message>
</context>
<context>
    <name>gripscope::InspectPage</name>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Rates…</source>
        <translation>Fehlerraten…</translation>
    </message>
    <message>
        <source>Squeeze (Space)</source>
        <translation>Drücken (Leertaste)</translation>
    </message>
    <message>
        <source>Arm the gripper</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Squeezing…</source>
        <translation>Drückt…</translation>
    </message>
    <message>
        <source>Judging…</source>
        <translation>Wird beurteilt…</translation>
    </message>
    <message>
        <source>Record (Space)</source>
        <translation>Aufnehmen (Leertaste)</translation>
    </message>
    <message>
        <source>Inspection %1</source>
        <translation>Prüfung %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>max. %1 s</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 s, at most %2 s</source>
        <translation>etwa %1 s, höchstens %2 s</translation>
    </message>
    <message>
        <source>Squeeze again (Space)</source>
        <translation>Erneut drücken (Leertaste)</translation>
    </message>
    <message>
        <source>part number</source>
        <translation>Teilenummer</translation>
    </message>
    <message>
        <source>Number of the next part</source>
        <translation>Nummer des nächsten Teils</translation>
    </message>
    <message>
        <source>Scan it anywhere on this page, or type it: kept with the next squeeze</source>
        <translation>Irgendwo auf dieser Seite scannen oder hier eintippen: wird mit dem nächsten Druckversuch gespeichert</translation>
    </message>
    <message>
        <source>Void…</source>
        <translation>Stornieren…</translation>
    </message>
    <message>
        <source>Void the last squeeze</source>
        <translation>Den letzten Druckversuch stornieren</translation>
    </message>
    <message>
        <source>Squeezed twice, or nothing in the jaws: the last squeeze then counts nowhere</source>
        <translation>Zweimal gedrückt oder nichts in den Backen: Der letzte Druckversuch zählt dann nirgends</translation>
    </message>
    <message>
        <source>Batch %1 has ended. Go on without a batch?</source>
        <translation>Los %1 ist beendet. Ohne Los weitermachen?</translation>
    </message>
    <message>
        <source>Further parts then belong to no batch. To count them, begin the next batch at the right.</source>
        <translation>Weitere Teile gehören dann zu keinem Los. Um sie zu zählen, rechts das nächste Los beginnen.</translation>
    </message>
    <message>
        <source>Go on without a batch</source>
        <translation>Ohne Los weiter</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Batch %1 is complete</source>
        <translation>Los %1 ist vollständig</translation>
    </message>
    <message>
        <source>Batch %1 has ended</source>
        <translation>Los %1 ist beendet</translation>
    </message>
    <message>
        <source>Adjusted to the gripper of the types: %1.</source>
        <translation>An den Greifer der Typen angepasst: %1.</translation>
    </message>
</context>
<context>
    <name>gripscope::InspectReason</name>
    <message>
        <source>posterior of %1: %2</source>
        <translation>Wahrscheinlichkeit für %1: %2</translation>
    </message>
    <message>
        <source>%1 sd from %2 (gate %3 sd)</source>
        <translation>%1 σ von %2 (Grenze %3 σ)</translation>
    </message>
    <message>
        <source>Held to: false-reject %1 (%2), wrong-type %3, stranger-accept %4</source>
        <translation>Soll: Fehlrückweisung %1 (%2), Verwechslung %3, Fremdannahme %4</translation>
    </message>
    <message>
        <source>with %1 confidence</source>
        <translation>mit %1 Vertrauen</translation>
    </message>
    <message>
        <source>on average</source>
        <translation>im Mittel</translation>
    </message>
    <message>
        <source>length %1, ended when it was decided</source>
        <translation>Dauer %1, beendet, als entschieden war</translation>
    </message>
    <message>
        <source>length %1</source>
        <translation>Dauer %1</translation>
    </message>
</context>
<context>
    <name>gripscope::InspectSummary</name>
    <message>
        <source>No part was inspected yet. Each squeeze is listed here with its verdict.</source>
        <translation>Noch wurde kein Teil geprüft. Jeder Druckversuch steht dann hier mit seinem Urteil.</translation>
    </message>
    <message>
        <source>%1 inspected</source>
        <translation>%1 geprüft</translation>
    </message>
    <message>
        <source>%1: %2 of %3, so at most %4</source>
        <translation>%1: %2 von %3, also höchstens %4</translation>
    </message>
    <message>
        <source>If each part was of the type expected:</source>
        <translation>Wenn jedes Teil vom erwarteten Typ war:</translation>
    </message>
    <message>
        <source>If each part was of type %1:</source>
        <translation>Wenn jedes Teil vom Typ %1 war:</translation>
    </message>
    <message>
        <source>other type</source>
        <translation>anderer Typ</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Exact bounds with 95 % confidence. Wrong type: %1</source>
        <translation>Exakte Grenzen mit 95 % Vertrauen. Anderer Typ: %1</translation>
    </message>
    <message>
        <source>Inspection %1</source>
        <translation>Prüfung %1</translation>
    </message>
    <message>
        <source>The last 20, the newest framed</source>
        <translation>Die letzten 20, das neueste umrahmt</translation>
    </message>
    <message>
        <source>New shift…</source>
        <translation>Neue Schicht…</translation>
    </message>
    <message>
        <source>Counts from now on. What was inspected before is kept in the history.</source>
        <translation>Zählt von jetzt an. Was vorher geprüft wurde, bleibt im Verlauf erhalten.</translation>
    </message>
    <message>
        <source>Begin a new shift?</source>
        <translation>Neue Schicht beginnen?</translation>
    </message>
    <message>
        <source>Its counts begin at 0. What was inspected is kept, and a batch goes on.</source>
        <translation>Ihre Zähler beginnen bei 0. Das Geprüfte bleibt erhalten, und ein Los geht weiter.</translation>
    </message>
    <message>
        <source>Begin it</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>This shift</source>
        <translation>Diese Schicht</translation>
    </message>
    <message>
        <source>All so far</source>
        <translation>Alle bisher</translation>
    </message>
    <message>
        <source>%1 voided</source>
        <translation>%1 storniert</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>%1 not conforming</source>
        <translation>%1 nicht konform</translation>
    </message>
</context>
<context>
    <name>gripscope::InspectionList</name>
    <message>
        <source>Last inspections</source>
        <translation>Letzte Prüfungen</translation>
    </message>
    <message>
        <source>Click a line to see its squeeze on the Fit page</source>
        <translation>Eine Zeile anklicken, um den Druckversuch auf der Seite Fit zu sehen</translation>
    </message>
</context>
<context>
    <name>gripscope::IntervalPlot</name>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Lower limit, 95 %</source>
        <translation>Untere Grenze, 95 %</translation>
    </message>
    <message>
        <source>Upper limit, 95 %</source>
        <translation>Obere Grenze, 95 %</translation>
    </message>
</context>
<context>
    <name>gripscope::IntervalText</name>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
</context>
<context>
    <name>gripscope::LagDialog</name>
    <message>
        <source>Lag between the channels</source>
        <translation>Zeitversatz der Kanäle</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>gripscope::LagStep</name>
    <message>
        <source>Squeeze %1 times</source>
        <translation>%1-mal drücken</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Use this lag</source>
        <translation>Diesen Versatz verwenden</translation>
    </message>
    <message>
        <source>A gripper samples the position a little later than the force. A lag of 100 µs that nobody knows of changes the mass of a can by a tenth. Grip something firm, a spring or a can of any type, and leave it there: the gripper squeezes it %1 times, with %2 for %3 s.</source>
        <translation>Ein Greifer tastet den Weg etwas später ab als die Kraft. Ein unbekannter Zeitversatz von 100 µs ändert die Masse einer Dose um ein Zehntel. Etwas Festes greifen, eine Feder oder eine Dose beliebigen Typs, und dort lassen: Der Greifer drückt sie %1-mal, mit %2, je %3 s lang.</translation>
    </message>
    <message>
        <source>In use: %1. It is kept for gripper %2, and its uncertainty goes into every error bar.</source>
        <translation>In Gebrauch: %1. Er gilt für Greifer %2, und seine Unsicherheit geht in jeden Fehlerbalken ein.</translation>
    </message>
    <message>
        <source>The position is sampled %1 (95 %) later than the force.</source>
        <translation>Der Weg wird %1 (95 %) später abgetastet als die Kraft.</translation>
    </message>
</context>
<context>
    <name>gripscope::Letterhead</name>
    <message>
        <source>%1. Choose another logo in the settings, or none.</source>
        <translation>%1. In den Optionen ein anderes Logo wählen oder keines.</translation>
    </message>
    <message>
        <source>it declares entities or a document type</source>
        <translation>sie vereinbart Entitäten oder einen Dokumenttyp</translation>
    </message>
    <message>
        <source>it names a style sheet or another program</source>
        <translation>sie nennt eine Formatvorlage oder ein anderes Programm</translation>
    </message>
    <message>
        <source>it has an element that reads files or repeats parts (%1)</source>
        <translation>sie hat ein Element, das Dateien liest oder Teile wiederholt (%1)</translation>
    </message>
    <message>
        <source>it is neither PNG nor SVG</source>
        <translation>sie ist weder PNG noch SVG</translation>
    </message>
    <message>
        <source>it is larger than %1 x %1 pixels, or damaged</source>
        <translation>sie ist größer als %1 x %1 Pixel oder beschädigt</translation>
    </message>
</context>
<context>
    <name>gripscope::LibraryDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Früher geöffnet</translation>
    </message>
    <message>
        <source>Libraries that were opened before</source>
        <translation>Bibliotheken, die früher geöffnet waren</translation>
    </message>
    <message>
        <source>Double-click, or Enter, opens it</source>
        <translation>Doppelklick oder Eingabetaste öffnet sie</translation>
    </message>
    <message>
        <source>Open another…</source>
        <translation>Andere öffnen…</translation>
    </message>
    <message>
        <source>Back up…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>A copy of all of it, verified; work goes on meanwhile</source>
        <translation>Eine nachgeprüfte Kopie von allem; die Arbeit geht weiter</translation>
    </message>
    <message>
        <source>Put back a backup…</source>
        <translation>Sicherung zurückspielen…</translation>
    </message>
    <message>
        <source>Shows what is in it before anything is changed</source>
        <translation>Zeigt, was darin steht, bevor etwas geändert wird</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Counting…</source>
        <translation>Wird gezählt…</translation>
    </message>
    <message>
        <source>Copied. Verifying every row of the copy…</source>
        <translation>Kopiert. Jede Zeile der Kopie wird nachgeprüft…</translation>
    </message>
    <message>
        <source>Open another library</source>
        <translation>Andere Bibliothek öffnen</translation>
    </message>
    <message>
        <source>Libraries (*.db *.gripscope);;All files (*)</source>
        <translation>Bibliotheken (*.db *.gripscope);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>The library %1 is open.</source>
        <translation>Die Bibliothek %1 ist geöffnet.</translation>
    </message>
    <message>
        <source>Back up the library</source>
        <translation>Bibliothek sichern</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Copying the library…</source>
        <translation>Bibliothek wird kopiert…</translation>
    </message>
    <message>
        <source>Put back a backup</source>
        <translation>Sicherung zurückspielen</translation>
    </message>
    <message>
        <source>Copying the backup beside the library, to verify it…</source>
        <translation>Die Sicherung wird neben die Bibliothek kopiert, um sie nachzuprüfen…</translation>
    </message>
    <message>
        <source>Putting it back…</source>
        <translation>Wird zurückgespielt…</translation>
    </message>
    <message>
        <source>The backup was put back. The library of before is kept as %1.</source>
        <translation>Die Sicherung wurde zurückgespielt. Die bisherige Bibliothek bleibt als %1.</translation>
    </message>
    <message>
        <source>A squeeze is under way. Wait for its end, then try again.</source>
        <translation>Ein Druckversuch läuft. Das Ende abwarten, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>A calibration is under way. Accept or leave it, then try again.</source>
        <translation>Eine Kalibrierung läuft. Erst übernehmen oder abbrechen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Inspections that are not stored yet: %1. Wait until they are, then try again.</source>
        <translation>Noch nicht gespeicherte Prüfungen: %1. Warten, bis sie gespeichert sind, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Wird geöffnet…</translation>
    </message>
    <message>
        <source>there is nothing in it</source>
        <translation>es steht nichts darin</translation>
    </message>
    <message>
        <source>The backup was written, but it holds what the library holds: %1</source>
        <translation>Die Sicherung wurde geschrieben, enthält aber, was die Bibliothek enthält: %1</translation>
    </message>
    <message>
        <source>The backup %1 was written and verified. %2</source>
        <translation>Die Sicherung %1 wurde geschrieben und nachgeprüft. %2</translation>
    </message>
    <message>
        <source>On a server…</source>
        <translation>Auf einem Server…</translation>
    </message>
    <message>
        <source>Opens a library that is a PostgreSQL database</source>
        <translation>Öffnet eine Bibliothek, die eine PostgreSQL-Datenbank ist</translation>
    </message>
</context>
<context>
    <name>gripscope::LibraryWords</name>
    <message>
        <source>inspections: %1</source>
        <translation>Prüfungen: %1</translation>
    </message>
    <message>
        <source>squeezes: %1</source>
        <translation>Druckversuche: %1</translation>
    </message>
    <message>
        <source>types: %1</source>
        <translation>Typen: %1</translation>
    </message>
    <message>
        <source>calibrations: %1</source>
        <translation>Kalibrierungen: %1</translation>
    </message>
    <message>
        <source>changes of types: %1</source>
        <translation>Änderungen an Typen: %1</translation>
    </message>
    <message>
        <source>entries of the audit trail: %1</source>
        <translation>Einträge im Änderungsprotokoll: %1</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>noch nichts</translation>
    </message>
    <message>
        <source>Types: %1, squeezes: %2, inspections: %3, calibrations: %4. Stored last: %5.</source>
        <translation>Typen: %1, Druckversuche: %2, Prüfungen: %3, Kalibrierungen: %4. Zuletzt gespeichert: %5.</translation>
    </message>
    <message>
        <source>The library of now cannot be read. It is kept aside as it is.</source>
        <translation>Die jetzige Bibliothek lässt sich nicht lesen. Sie wird beiseitegelegt, wie sie ist.</translation>
    </message>
    <message>
        <source>Nothing was stored since this backup was made.</source>
        <translation>Seit dieser Sicherung wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>What was stored since this backup was made goes out of use (%1). It stays in the library that is kept aside.</source>
        <translation>Was seit dieser Sicherung gespeichert wurde, wird außer Gebrauch genommen (%1). Es bleibt in der Bibliothek, die beiseitegelegt wird.</translation>
    </message>
    <message>
        <source>The backup and the library have gone different ways: each holds something that the other does not. All of the library of now goes out of use, and is kept aside.</source>
        <translation>Sicherung und Bibliothek haben sich auseinanderentwickelt: In beiden steht etwas, das in der anderen fehlt. Die ganze jetzige Bibliothek wird außer Gebrauch genommen und beiseitegelegt.</translation>
    </message>
    <message>
        <source>This is a copy of another library. All of the library of now goes out of use, and is kept aside.</source>
        <translation>Das ist die Kopie einer anderen Bibliothek. Die ganze jetzige Bibliothek wird außer Gebrauch genommen und beiseitegelegt.</translation>
    </message>
</context>
<context>
    <name>gripscope::LimitFields</name>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>%1, at least</source>
        <translation>%1, mindestens</translation>
    </message>
    <message>
        <source>%1, at most</source>
        <translation>%1, höchstens</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
</context>
<context>
    <name>gripscope::LinkWords</name>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>vor %1 min</translation>
    </message>
    <message>
        <source>%1 h ago</source>
        <translation>vor %1 h</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 doppelt</translation>
    </message>
    <message>
        <source>%1 damaged</source>
        <translation>%1 beschädigt</translation>
    </message>
    <message>
        <source>%1 silent (%2 s)</source>
        <translation>%1 stumm (%L2 s)</translation>
    </message>
    <message>
        <source>1 clock jump</source>
        <translation>1 Uhrsprung</translation>
    </message>
    <message>
        <source>%1 clock jumps</source>
        <translation>%1 Uhrsprünge</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>einwandfrei</translation>
    </message>
    <message>
        <source>%1 ms, most %2 ms</source>
        <translation>%1 ms, höchstens %2 ms</translation>
    </message>
    <message>
        <source>loading</source>
        <translation>lädt</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>%1 of %2 %3</source>
        <translation>%1 von %2 %3</translation>
    </message>
</context>
<context>
    <name>gripscope::LiveChannelCard</name>
    <message>
        <source>%1 over time</source>
        <translation>%1 über der Zeit</translation>
    </message>
    <message>
        <source>tared</source>
        <translation>tariert</translation>
    </message>
    <message>
        <source>What this program asks of the gripper while it squeezes; without tare</source>
        <translation>Was dieses Programm vom Greifer verlangt, während er drückt; ohne Tara</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>in view
%1 to %2 %3</source>
        <translation>im Bild
%1 bis %2 %3</translation>
    </message>
    <message>
        <source>commanded %1 %2</source>
        <translation>verlangt %1 %2</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
</context>
<context>
    <name>gripscope::LiveEstimateCard</name>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>m, b and k appear here while the gripper squeezes</source>
        <translation>m, b und k erscheinen hier, während der Greifer drückt</translation>
    </message>
    <message>
        <source>this squeeze so far</source>
        <translation>dieser Druckversuch bisher</translation>
    </message>
    <message>
        <source>the last squeeze</source>
        <translation>der letzte Druckversuch</translation>
    </message>
</context>
<context>
    <name>gripscope::LiveLinkPanel</name>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Reports</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Lost samples</source>
        <translation>Verlorene Abtastwerte</translation>
    </message>
    <message>
        <source>Latency to the screen</source>
        <translation>Latenz bis zum Bild</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>Travel limit</source>
        <translation>Weggrenze</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Druckversuch</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Datenstrom</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>cannot be seen</source>
        <translation>nicht zu sehen</translation>
    </message>
    <message>
        <source>cannot move</source>
        <translation>nicht möglich</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>gripscope::LiveMarkerModel</name>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Worte</translation>
    </message>
</context>
<context>
    <name>gripscope::LiveMeasurePanel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Time from A to B</source>
        <translation>Zeit von A bis B</translation>
    </message>
    <message>
        <source>Change of force from A to B</source>
        <translation>Änderung der Kraft von A bis B</translation>
    </message>
    <message>
        <source>Change of position from A to B</source>
        <translation>Änderung des Wegs von A bis B</translation>
    </message>
    <message>
        <source>Slope: change of force over change of position</source>
        <translation>Steigung: Kraftänderung durch Wegänderung</translation>
    </message>
    <message>
        <source>The stiffness, where the part is at rest at A and at B; while it moves, mass and damping are in it too</source>
        <translation>Die Steifigkeit, wenn das Teil bei A und bei B ruht; in Bewegung stecken auch Masse und Dämpfung darin</translation>
    </message>
    <message>
        <source>Slope dF/dx</source>
        <translation>Steigung dF/dx</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Time of cursor %1, seconds</source>
        <translation>Zeit des Cursors %1, Sekunden</translation>
    </message>
    <message>
        <source>Cursor A: drag it, or Shift and the arrows in a chart</source>
        <translation>Cursor A: ziehen, oder Umschalt und Pfeiltasten im Diagramm</translation>
    </message>
    <message>
        <source>Cursor B: drag it, or Ctrl and the arrows in a chart</source>
        <translation>Cursor B: ziehen, oder Strg und Pfeiltasten im Diagramm</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Force at cursor %1</source>
        <translation>Kraft am Cursor %1</translation>
    </message>
    <message>
        <source>Position at cursor %1</source>
        <translation>Weg am Cursor %1</translation>
    </message>
    <message>
        <source>Show less time (+)</source>
        <translation>Weniger Zeit zeigen (+)</translation>
    </message>
    <message>
        <source>Show more time (−)</source>
        <translation>Mehr Zeit zeigen (−)</translation>
    </message>
    <message>
        <source>Earlier (left arrow)</source>
        <translation>Früher (Pfeil links)</translation>
    </message>
    <message>
        <source>Later (right arrow)</source>
        <translation>Später (Pfeil rechts)</translation>
    </message>
    <message>
        <source>All as it was paused (Home)</source>
        <translation>Alles wie angehalten (Pos1)</translation>
    </message>
    <message>
        <source>Cursors into view</source>
        <translation>Cursor ins Bild</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Saves what is in view as a recording (CSV), as far as it is kept sample by sample: the last minute</source>
        <translation>Speichert das Sichtbare als Aufnahme (CSV), soweit es Wert für Wert aufbewahrt ist: die letzte Minute</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Markers (M drops one); a double click on the words changes them</source>
        <translation>Marken (M setzt eine); Doppelklick auf die Worte ändert sie</translation>
    </message>
    <message>
        <source>Remove the selected markers</source>
        <translation>Gewählte Marken entfernen</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Speichert…</translation>
    </message>
</context>
<context>
    <name>gripscope::LivePage</name>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>2 s</source>
        <translation>2 s</translation>
    </message>
    <message>
        <source>10 s</source>
        <translation>10 s</translation>
    </message>
    <message>
        <source>1 min</source>
        <translation>1 min</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>Show the last %1</source>
        <translation>Die letzten %1 zeigen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Tare</source>
        <translation>Tarieren</translation>
    </message>
    <message>
        <source>Shows force and position from here on; what is recorded stays as it is</source>
        <translation>Zeigt Kraft und Weg ab hier; das Aufgenommene bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Trial squeeze</source>
        <translation>Probedruck</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Cancel squeeze</source>
        <translation>Druck abbrechen</translation>
    </message>
    <message>
        <source>Record 1 s</source>
        <translation>1 s aufnehmen</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>This gripper only streams: squeeze by its own program, and record.</source>
        <translation>Dieser Greifer sendet nur: mit seinem eigenen Programm drücken und aufnehmen.</translation>
    </message>
    <message>
        <source>Armed. The result of a trial squeeze opens on the Fit page; nothing is stored.</source>
        <translation>Scharf. Das Ergebnis eines Probedrucks öffnet sich auf der Seite Fit; nichts wird gespeichert.</translation>
    </message>
    <message>
        <source>Tared</source>
        <translation>Tariert</translation>
    </message>
    <message>
        <source>Holds the charts, to zoom, move and measure in them; measuring goes on</source>
        <translation>Hält die Diagramme an, um darin zu vergrößern, zu verschieben und zu messen; das Messen geht weiter</translation>
    </message>
    <message>
        <source>Drop a marker (M): at the newest sample, or at the cursor moved last</source>
        <translation>Eine Marke setzen (M): beim neuesten Abtastwert oder am zuletzt bewegten Cursor</translation>
    </message>
    <message>
        <source>A marker needs something measured. Connect a gripper first.</source>
        <translation>Eine Marke braucht etwas Gemessenes. Erst einen Greifer verbinden.</translation>
    </message>
    <message>
        <source>Hands clear, then arm: a trial squeeze pushes with %1 for %2 s.</source>
        <translation>Hände weg, dann scharf schalten: Ein Probedruck drückt mit %1, %2 s lang.</translation>
    </message>
</context>
<context>
    <name>gripscope::LivePause</name>
    <message>
        <source>A</source>
        <comment>first cursor</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <comment>second cursor</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>position does not change</source>
        <translation>Weg ändert sich nicht</translation>
    </message>
</context>
<context>
    <name>gripscope::LiveSave</name>
    <message>
        <source>Nothing in view is kept sample by sample any more: that is done for the last minute. Show a later time, then save again.</source>
        <translation>Nichts Sichtbares ist noch Wert für Wert aufbewahrt: Das geschieht für die letzte Minute. Eine spätere Zeit zeigen, dann erneut speichern.</translation>
    </message>
    <message>
        <source>Save what is in view</source>
        <translation>Sichtbares speichern</translation>
    </message>
    <message>
        <source>Recording (*.csv)</source>
        <translation>Aufnahme (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1: the last %2 s of what is in view. What was before is no longer kept sample by sample.</source>
        <translation>Gespeichert als %1: die letzten %2 s des Sichtbaren. Das davor ist nicht mehr Wert für Wert aufbewahrt.</translation>
    </message>
    <message>
        <source>Saved as %1: %2 s.</source>
        <translation>Gespeichert als %1: %2 s.</translation>
    </message>
</context>
<context>
    <name>gripscope::LiveTrial</name>
    <message>
        <source>Trial squeeze %1</source>
        <translation>Probedruck %1</translation>
    </message>
</context>
<context>
    <name>gripscope::MainWindow</name>
    <message>
        <source>Gripscope</source>
        <translation>Gripscope</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Language, theme, rates and more (Ctrl+,)</source>
        <translation>Sprache, Farben, Fehlerraten und mehr (Strg+,)</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>The manual, at the page about this screen (F1)</source>
        <translation>Das Handbuch, auf der Seite zu diesem Bild (F1)</translation>
    </message>
    <message>
        <source>Close and lose what is not stored?</source>
        <translation>Schließen und nicht Gespeichertes verlieren?</translation>
    </message>
    <message>
        <source>Not stored yet: %1. They are stored as soon as that can be, while the program runs. %2</source>
        <translation>Noch nicht gespeichert: %1. Sie werden gespeichert, sobald es geht, solange das Programm läuft. %2</translation>
    </message>
    <message>
        <source>Close and lose them</source>
        <translation>Schließen und verlieren</translation>
    </message>
    <message>
        <source>Keep it open</source>
        <translation>Geöffnet lassen</translation>
    </message>
</context>
<context>
    <name>gripscope::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Das Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Seiten des Handbuchs</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Keys and version…</source>
        <translation>Tasten und Version…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>On no page. Try another word.</source>
        <translation>Auf keiner Seite. Ein anderes Wort versuchen.</translation>
    </message>
</context>
<context>
    <name>gripscope::MapPanel</name>
    <message>
        <source>Dots: squeezes a unit. White lines: borders between clusters.</source>
        <translation>Punkte: Druckversuche je Einheit. Weiße Linien: Grenzen zwischen Clustern.</translation>
    </message>
</context>
<context>
    <name>gripscope::MapPlanes</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>No squeezes here</source>
        <translation>Keine Druckversuche hier</translation>
    </message>
    <message>
        <source>Squeezes: %1</source>
        <translation>Druckversuche: %1</translation>
    </message>
    <message>
        <source>Row %1, column %2 of the map, cluster %3</source>
        <translation>Zeile %1, Spalte %2 der Karte, Cluster %3</translation>
    </message>
    <message>
        <source>U-matrix</source>
        <translation>U-Matrix</translation>
    </message>
    <message>
        <source>How far each unit is from its neighbours, in the scaled space. Bright ridges are borders between clusters.</source>
        <translation>Wie weit jede Einheit von ihren Nachbarn entfernt ist, im skalierten Raum. Helle Grate sind Grenzen zwischen Clustern.</translation>
    </message>
    <message>
        <source>Mass m</source>
        <translation>Masse m</translation>
    </message>
    <message>
        <source>The mass that each unit stands for</source>
        <translation>Die Masse, für die jede Einheit steht</translation>
    </message>
    <message>
        <source>Damping b</source>
        <translation>Dämpfung b</translation>
    </message>
    <message>
        <source>The damping that each unit stands for</source>
        <translation>Die Dämpfung, für die jede Einheit steht</translation>
    </message>
    <message>
        <source>Stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>The stiffness that each unit stands for</source>
        <translation>Die Steifigkeit, für die jede Einheit steht</translation>
    </message>
</context>
<context>
    <name>gripscope::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gripscope::ModelPanel</name>
    <message>
        <source>A lower criterion explains the squeeze better for the parameters it spends. Less than 10 apart, nothing is decided.</source>
        <translation>Ein niedrigeres Kriterium erklärt den Druckversuch mit seinen Parametern besser. Bei weniger als 10 Abstand ist nichts entschieden.</translation>
    </message>
    <message>
        <source>Models against each other</source>
        <translation>Modelle im Vergleich</translation>
    </message>
    <message>
        <source>What the periods tell</source>
        <translation>Was die Perioden verraten</translation>
    </message>
    <message>
        <source>No other model was compared with this one.</source>
        <translation>Kein anderes Modell wurde mit diesem verglichen.</translation>
    </message>
</context>
<context>
    <name>gripscope::OpenedRecordings</name>
    <message>
        <source>The recording before (Alt+Up)</source>
        <translation>Die Aufnahme davor (Alt+Oben)</translation>
    </message>
    <message>
        <source>The next recording (Alt+Down)</source>
        <translation>Die nächste Aufnahme (Alt+Unten)</translation>
    </message>
    <message>
        <source>Open recordings</source>
        <translation>Aufnahmen öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Aufnahmen (*.csv *.tsv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>reading %1 (%2 of %3)…</source>
        <translation>liest %1 (%2 von %3)…</translation>
    </message>
    <message>
        <source>reading %1…</source>
        <translation>liest %1…</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>gripscope::OperatorBox</name>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Who works here: kept with every squeeze</source>
        <translation>Wer hier arbeitet: steht bei jedem Druckversuch</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Nobody has signed in</source>
        <translation>Niemand ist angemeldet</translation>
    </message>
    <message>
        <source>Sign in as somebody else…</source>
        <translation>Als jemand anders anmelden…</translation>
    </message>
    <message>
        <source>Sign in…</source>
        <translation>Anmelden…</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>People…</source>
        <translation>Personen…</translation>
    </message>
    <message>
        <source>Audit trail…</source>
        <translation>Änderungsprotokoll…</translation>
    </message>
    <message>
        <source>People, the audit trail and the library</source>
        <translation>Personen, Änderungsprotokoll und Bibliothek</translation>
    </message>
    <message>
        <source>Library…</source>
        <translation>Bibliothek…</translation>
    </message>
</context>
<context>
    <name>gripscope::Outcome</name>
    <message>
        <source>as expected</source>
        <translation>wie erwartet</translation>
    </message>
    <message>
        <source>other type</source>
        <translation>anderer Typ</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>inconclusive</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>It could be %1 (%2) or %3 (%4)</source>
        <translation>Es könnte %1 (%2) oder %3 (%4) sein</translation>
    </message>
    <message>
        <source>%1, and a longer squeeze would not tell them apart.</source>
        <translation>%1, und längeres Drücken würde sie nicht trennen.</translation>
    </message>
    <message>
        <source>%1: squeeze it again.</source>
        <translation>%1: erneut drücken.</translation>
    </message>
    <message>
        <source>%1: squeezed for %2 s, nine of ten would be told apart.</source>
        <translation>%1: Bei %2 s Drücken wären neun von zehn zu unterscheiden.</translation>
    </message>
    <message>
        <source>known type, none was expected</source>
        <translation>bekannter Typ, keiner war erwartet</translation>
    </message>
    <message>
        <source>other type; expected %1</source>
        <translation>anderer Typ; erwartet %1</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>no type is enrolled yet</source>
        <translation>noch ist kein Typ eingelernt</translation>
    </message>
    <message>
        <source>none of the enrolled types</source>
        <translation>keiner der eingelernten Typen</translation>
    </message>
    <message>
        <source>%1 or %2?</source>
        <translation>%1 oder %2?</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Squeeze again</source>
        <translation>Erneut drücken</translation>
    </message>
    <message>
        <source>measurement not valid; part not judged</source>
        <translation>Messung ungültig; Teil nicht beurteilt</translation>
    </message>
    <message>
        <source>suspect: %1</source>
        <translation>fraglich: %1</translation>
    </message>
    <message>
        <source>SUSPECT: %1</source>
        <translation>FRAGLICH: %1</translation>
    </message>
    <message>
        <source>Suspect: %1</source>
        <translation>Fraglich: %1</translation>
    </message>
    <message>
        <source>%1 · not stored yet</source>
        <translation>%1 · noch nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 · NOT STORED</source>
        <translation>%1 · NICHT GESPEICHERT</translation>
    </message>
    <message>
        <source>known type</source>
        <translation>bekannter Typ</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
    <message>
        <source>refused by the settings</source>
        <translation>durch die Einstellungen verweigert</translation>
    </message>
    <message>
        <source>Call your supervisor</source>
        <translation>Aufsicht rufen</translation>
    </message>
    <message numerus="yes">
        <source>%n squeezes in a row were not valid</source>
        <translation>
            <numerusform>%n Druckversuch in Folge war ungültig</numerusform>
            <numerusform>%n Druckversuche in Folge waren ungültig</numerusform>
        </translation>
    </message>
    <message>
        <source>VOIDED, does not count: %1</source>
        <translation>STORNIERT, zählt nicht: %1</translation>
    </message>
    <message>
        <source>as expected or known type</source>
        <translation>wie erwartet oder bekannt</translation>
    </message>
    <message>
        <source>%1?</source>
        <translation>%1?</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>nicht konform</translation>
    </message>
</context>
<context>
    <name>gripscope::OverlayDialog</name>
    <message>
        <source>Squeezes over each other</source>
        <translation>Druckversuche übereinander</translation>
    </message>
    <message>
        <source>squeezes</source>
        <translation>Druckversuche</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wird gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>%n squeeze(s), each from its start</source>
        <translation>
            <numerusform>%n Druckversuch, ab seinem Beginn</numerusform>
            <numerusform>%n Druckversuche, jeder ab seinem Beginn</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 chosen squeezes, each from its start: at most %3, in the units of the first</source>
        <translation>%1 von %2 gewählten Druckversuchen, jeder ab seinem Beginn: höchstens %3, in den Einheiten des ersten</translation>
    </message>
</context>
<context>
    <name>gripscope::OverlayPlots</name>
    <message>
        <source>Squeezes over each other</source>
        <translation>Druckversuche übereinander</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
</context>
<context>
    <name>gripscope::PageView</name>
    <message>
        <source>Scrolls the page</source>
        <translation>Rollt die Seite</translation>
    </message>
</context>
<context>
    <name>gripscope::PairPlots</name>
    <message>
        <source>This computer has no OpenGL 3.2, so the space is shown as three plots instead of a scene.</source>
        <translation>Dieser Rechner hat kein OpenGL 3.2, daher zeigt statt der Szene je ein Diagramm drei Ansichten des Raums.</translation>
    </message>
</context>
<context>
    <name>gripscope::PartPictureView</name>
    <message>
        <source>Picture of the part: none</source>
        <translation>Bild des Teils: keines</translation>
    </message>
    <message>
        <source>Picture of the part</source>
        <translation>Bild des Teils</translation>
    </message>
</context>
<context>
    <name>gripscope::PdfDocument</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>gripscope::PeopleDialog</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Make supervisor</source>
        <translation>Zur Aufsicht</translation>
    </message>
    <message>
        <source>Change who may arm</source>
        <translation>Ändern, wer scharf schalten darf</translation>
    </message>
    <message>
        <source>Change who may approve</source>
        <translation>Ändern, wer freigeben darf</translation>
    </message>
    <message>
        <source>New PIN…</source>
        <translation>Neue PIN…</translation>
    </message>
    <message>
        <source>New PIN or password</source>
        <translation>Neue PIN oder neues Passwort</translation>
    </message>
    <message>
        <source>Deactivate</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Nobody is in this library yet, so everything is allowed to everybody, and the operator&apos;s name is what somebody typed. Add the first person, who must be a supervisor, and roles are in force from then on.</source>
        <translation>Noch ist niemand in dieser Bibliothek: Alle dürfen alles, und als Bediener gilt, was jemand eintippt. Mit der ersten Person, die Aufsicht sein muss, gelten von da an Rollen.</translation>
    </message>
    <message>
        <source>Roles are in force. Who leaves is deactivated, not deleted: what they did stays in the audit trail.</source>
        <translation>Rollen gelten. Wer geht, wird gesperrt, nicht gelöscht: Was diese Person getan hat, bleibt im Änderungsprotokoll.</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>deactivated</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>Make operator</source>
        <translation>Zur Bedienung</translation>
    </message>
    <message>
        <source>Reactivate</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>everybody who has signed in</source>
        <translation>alle, die angemeldet sind</translation>
    </message>
    <message>
        <source>supervisors; others ask one each time</source>
        <translation>Aufsicht; andere fragen jedes Mal</translation>
    </message>
    <message>
        <source>Who may arm the gripper</source>
        <translation>Wer scharf schalten darf</translation>
    </message>
    <message>
        <source>any supervisor</source>
        <translation>jede Aufsicht</translation>
    </message>
    <message>
        <source>a supervisor who did not enroll it</source>
        <translation>eine Aufsicht, die ihn nicht eingelernt hat</translation>
    </message>
    <message>
        <source>Who may approve a type</source>
        <translation>Wer einen Typ freigeben darf</translation>
    </message>
</context>
<context>
    <name>gripscope::PersonForm</name>
    <message>
        <source>Add the first supervisor</source>
        <translation>Erste Aufsicht hinzufügen</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>From now on roles are in force in this library: changing rates, limits, types, calibrations, settings and people needs a supervisor. This cannot be taken back, and nobody can read or reset a lost PIN or password but another supervisor: add a second one soon.</source>
        <translation>Von jetzt an gelten in dieser Bibliothek Rollen: Fehlerraten, Grenzen, Typen, Kalibrierungen, Einstellungen und Personen ändert nur eine Aufsicht. Das lässt sich nicht zurücknehmen. Eine verlorene PIN kann niemand lesen und nur eine andere Aufsicht ersetzen: bald eine zweite hinzufügen.</translation>
    </message>
    <message>
        <source>Operators squeeze, inspect and enroll. Supervisors also change rates, limits, types, calibrations, settings and people.</source>
        <translation>Die Bedienung drückt, prüft und lernt ein. Die Aufsicht ändert auch Fehlerraten, Grenzen, Typen, Kalibrierungen, Einstellungen und Personen.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Name, as it is to stand in the audit trail</source>
        <translation>Name, wie er im Änderungsprotokoll stehen soll</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>New PIN or password</source>
        <translation>Neue PIN oder neues Passwort</translation>
    </message>
    <message>
        <source>For %1. The old one no longer counts, and a wait after wrong tries ends.</source>
        <translation>Für %1. Das alte gilt nicht mehr, und eine Wartezeit nach falschen Versuchen endet.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>PIN of %1 digits or more, or password of %2 characters or more</source>
        <translation>PIN ab %1 Ziffern oder Passwort ab %2 Zeichen</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>Noch einmal dasselbe</translation>
    </message>
    <message>
        <source>The person needs a name.</source>
        <translation>Die Person braucht einen Namen.</translation>
    </message>
    <message>
        <source>The two are not the same. Type the second one again.</source>
        <translation>Die beiden stimmen nicht überein. Das zweite noch einmal eintippen.</translation>
    </message>
</context>
<context>
    <name>gripscope::ProcessCapabilityPanel</name>
    <message>
        <source>Capability</source>
        <translation>Fähigkeit</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>Typed here; the type keeps its own.</source>
        <translation>Hier getippt; der Typ behält seine eigenen.</translation>
    </message>
    <message>
        <source>The type&apos;s own tolerance limits.</source>
        <translation>Die eigenen Toleranzgrenzen des Typs.</translation>
    </message>
    <message>
        <source>A limit is a number, or nothing.</source>
        <translation>Eine Grenze ist eine Zahl oder nichts.</translation>
    </message>
</context>
<context>
    <name>gripscope::ProcessControls</name>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>m, b and k</source>
        <translation>m, b und k</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>n = </source>
        <comment>size of a subgroup</comment>
        <translation>n = </translation>
    </message>
    <message>
        <source>Inspections in a subgroup</source>
        <translation>Prüfungen in einer Stichprobe</translation>
    </message>
    <message>
        <source>Filters</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>All stations</source>
        <translation>Alle Stationen</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>All grippers</source>
        <translation>Alle Greifer</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>All operators</source>
        <translation>Alle Bediener</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>All batches</source>
        <translation>Alle Chargen</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Jederzeit</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>From … to …</source>
        <translation>Von … bis …</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Erster Tag</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Letzter Tag</translation>
    </message>
    <message>
        <source>Filters (%1)</source>
        <translation>Filter (%1)</translation>
    </message>
</context>
<context>
    <name>gripscope::ProcessReport</name>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Inspections</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Von, bis</translation>
    </message>
    <message>
        <source>Only</source>
        <translation>Nur</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Steady: no signal.</source>
        <translation>Ruhig: kein Signal.</translation>
    </message>
    <message>
        <source>Not steady: %1 signals, the newest %2 of them below.</source>
        <translation>Nicht ruhig: %1 Signale, die neuesten %2 davon unten.</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Since inspection</source>
        <translation>Seit Prüfung</translation>
    </message>
    <message>
        <source>Capability: %1</source>
        <translation>Fähigkeit: %1</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>Control charts: %1</source>
        <translation>Regelkarten: %1</translation>
    </message>
    <message>
        <source>Made %1 by %2 with Gripscope %3.</source>
        <translation>Erstellt %1 von %2 mit Gripscope %3.</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>jemand ohne Namen</translation>
    </message>
</context>
<context>
    <name>gripscope::ProcessSignalList</name>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Since inspection</source>
        <translation>Seit Prüfung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Steady: no signal.</source>
        <translation>Ruhig: kein Signal.</translation>
    </message>
    <message>
        <source>Not steady: %1 signals; the newest %2 are listed.</source>
        <translation>Nicht ruhig: %1 Signale; die neuesten %2 sind aufgeführt.</translation>
    </message>
    <message>
        <source>Not steady: one signal.</source>
        <translation>Nicht ruhig: ein Signal.</translation>
    </message>
    <message>
        <source>Not steady: %1 signals.</source>
        <translation>Nicht ruhig: %1 Signale.</translation>
    </message>
</context>
<context>
    <name>gripscope::ProcessView</name>
    <message>
        <source>Points written to %1</source>
        <translation>Punkte in %1 geschrieben</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Bericht in %1 geschrieben</translation>
    </message>
    <message>
        <source>All studies</source>
        <translation>Alle Studien</translation>
    </message>
    <message>
        <source>Fix limits</source>
        <translation>Grenzen festlegen</translation>
    </message>
    <message>
        <source>From the inspections in view (drag over a stretch to bring it into view): later ones are then judged by these limits, and Inspect tells what they signal</source>
        <translation>Aus den Prüfungen im Bild (über einen Abschnitt ziehen holt ihn ins Bild): Spätere werden dann nach diesen Grenzen beurteilt, und Prüfen sagt, was sie melden</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>No fixed limits any more: the inspections shown settle them</source>
        <translation>Keine festgelegten Grenzen mehr: Die gezeigten Prüfungen bestimmen sie</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Every point of these charts, as a table</source>
        <translation>Jeder Punkt dieser Karten, als Tabelle</translation>
    </message>
    <message>
        <source>Report (PDF)…</source>
        <translation>Bericht (PDF)…</translation>
    </message>
    <message>
        <source>Save the charts&apos; points</source>
        <translation>Punkte der Karten speichern</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Reading the inspections…</source>
        <translation>Prüfungen werden gelesen…</translation>
    </message>
    <message>
        <source>Drawing the charts…</source>
        <translation>Karten werden gezeichnet…</translation>
    </message>
    <message>
        <source>The inspections could not be read.</source>
        <translation>Die Prüfungen ließen sich nicht lesen.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>No type is enrolled yet. Enroll one, then inspect parts of it: the charts show how their m, b and k go.</source>
        <translation>Noch ist kein Typ eingelernt. Einen einlernen, dann Teile davon prüfen: Die Karten zeigen, wie ihre m, b und k verlaufen.</translation>
    </message>
    <message>
        <source>No inspection has recognised a part of this type yet.</source>
        <translation>Noch keine Prüfung hat ein Teil dieses Typs erkannt.</translation>
    </message>
    <message>
        <source>No inspection matches the filters.</source>
        <translation>Keine Prüfung passt zu den Filtern.</translation>
    </message>
    <message>
        <source>%1 inspections</source>
        <translation>%1 Prüfungen</translation>
    </message>
</context>
<context>
    <name>gripscope::ProfileDialog</name>
    <message>
        <source>Name a gripper, then listen. Nothing is sent to it.</source>
        <translation>Einen Greifer nennen, dann abhören. Ihm wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Listening; no report came yet.</source>
        <translation>Hört ab; noch kam kein Report.</translation>
    </message>
    <message>
        <source>%1 bytes, %2 reports a second.</source>
        <translation>%1 Bytes, %2 Reports je Sekunde.</translation>
    </message>
    <message>
        <source>What gets lost cannot be seen.</source>
        <translation>Verluste sind nicht zu sehen.</translation>
    </message>
    <message>
        <source>Lost samples: %1.</source>
        <translation>Verlorene Abtastwerte: %1.</translation>
    </message>
    <message>
        <source>Not as the profile says: %1.</source>
        <translation>Nicht, wie das Profil sagt: %1.</translation>
    </message>
    <message>
        <source>Profile of another maker&apos;s gripper</source>
        <translation>Profil für Greifer anderer Hersteller</translation>
    </message>
    <message>
        <source>Bytes (● moves, ◀ chosen field)</source>
        <translation>Bytes (● bewegt sich, ◀ gewähltes Feld)</translation>
    </message>
    <message>
        <source>Bytes of the last report</source>
        <translation>Bytes des letzten Reports</translation>
    </message>
    <message>
        <source>The profile as a JSON document</source>
        <translation>Das Profil als JSON-Dokument</translation>
    </message>
    <message>
        <source>Force of the last seconds</source>
        <translation>Kraft der letzten Sekunden</translation>
    </message>
    <message>
        <source>Position of the last seconds</source>
        <translation>Weg der letzten Sekunden</translation>
    </message>
    <message>
        <source>Address of the gripper</source>
        <translation>Adresse des Greifers</translation>
    </message>
    <message>
        <source>hid:VENDOR:PRODUCT, or virtual:?like=walkthrough to try it</source>
        <translation>hid:HERSTELLER:PRODUKT, oder virtual:?like=walkthrough zum Ausprobieren</translation>
    </message>
    <message>
        <source>Listen</source>
        <translation>Abhören</translation>
    </message>
    <message>
        <source>Show as JSON</source>
        <translation>Als JSON</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save to my profiles</source>
        <translation>Zu meinen Profilen</translation>
    </message>
    <message>
        <source>⚠ %1: %2. Expected: %3.</source>
        <translation>⚠ %1: %2. Erwartet: %3.</translation>
    </message>
    <message>
        <source>…and %1 more.</source>
        <translation>…und %1 weitere.</translation>
    </message>
    <message>
        <source>Load a profile</source>
        <translation>Ein Profil laden</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>Profile (*.json)</translation>
    </message>
    <message>
        <source>Saved as %1. The gripper is found by it from now on.</source>
        <translation>Gespeichert als %1. Der Greifer wird ab jetzt daran erkannt.</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
</context>
<context>
    <name>gripscope::ProfileFieldRow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>Flags</translation>
    </message>
    <message>
        <source>first byte</source>
        <translation>erstes Byte</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>little</source>
        <translation>little</translation>
    </message>
    <message>
        <source>big</source>
        <translation>big</translation>
    </message>
    <message>
        <source>which byte comes first: the lowest (little) or the highest (big)</source>
        <translation>welches Byte zuerst kommt: das niedrigste (little) oder das höchste (big)</translation>
    </message>
    <message>
        <source>0 moving, 4 force_saturated</source>
        <translation>0 moving, 4 force_saturated</translation>
    </message>
    <message>
        <source>bits and what they mean: %1</source>
        <translation>Bits und was sie bedeuten: %1</translation>
    </message>
    <message>
        <source>what it counts</source>
        <translation>was er zählt</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>units in one count</source>
        <translation>Einheiten je Stufe</translation>
    </message>
    <message>
        <source>added to the value, in its unit</source>
        <translation>zum Wert addiert, in seiner Einheit</translation>
    </message>
</context>
<context>
    <name>gripscope::ProfileForm</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>held (zoh)</source>
        <translation>fest (zoh)</translation>
    </message>
    <message>
        <source>straight (foh)</source>
        <translation>Linie (foh)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>USB vendor</source>
        <translation>USB-Hersteller</translation>
    </message>
    <message>
        <source>USB product</source>
        <translation>USB-Produkt</translation>
    </message>
    <message>
        <source>Report ID</source>
        <translation>Report-ID</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Bytes apart</source>
        <translation>Abstand (B)</translation>
    </message>
    <message>
        <source>Samples/s</source>
        <translation>Werte je s</translation>
    </message>
    <message>
        <source>Force goes on</source>
        <translation>Kraftverlauf</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Byte</source>
        <translation>Byte</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Added</source>
        <translation>Addiert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Says now</source>
        <translation>Wert jetzt</translation>
    </message>
</context>
<context>
    <name>gripscope::ProgressRing</name>
    <message>
        <source>%1 of %2 squeezes</source>
        <translation>%1 von %2 Druckversuchen</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
</context>
<context>
    <name>gripscope::QualityPage</name>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Gauge %1</source>
        <translation>Messmittel %1</translation>
    </message>
    <message>
        <source>Type-1 %1</source>
        <translation>Typ 1, %1</translation>
    </message>
    <message>
        <source>Linearity %1</source>
        <translation>Linearität %1</translation>
    </message>
    <message>
        <source>Attributes %1</source>
        <translation>Urteile %1</translation>
    </message>
    <message>
        <source>Cola 330 ml, tray 1</source>
        <translation>Cola 330 ml, Palette 1</translation>
    </message>
</context>
<context>
    <name>gripscope::RatesDialog</name>
    <message>
        <source>Rates</source>
        <translation>Fehlerraten</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>False-reject rate</source>
        <translation>Fehlrückweisungsrate</translation>
    </message>
    <message>
        <source>Of the squeezes of enrolled types, the share that may be called unknown.</source>
        <translation>Anteil der Druckversuche, der zu Unrecht unbekannt heißen darf.</translation>
    </message>
    <message>
        <source>Wrong-type rate</source>
        <translation>Verwechslungsrate</translation>
    </message>
    <message>
        <source>Of the squeezes of enrolled types, the share that may be named another type.</source>
        <translation>Anteil der Druckversuche, der als falscher Typ benannt werden darf.</translation>
    </message>
    <message>
        <source>Stranger-accept rate</source>
        <translation>Fremdannahmerate</translation>
    </message>
    <message>
        <source>Of parts of no enrolled type, spread evenly over all that the gripper may meet, the share that may be named a type.</source>
        <translation>Anteil fremder Teile, gleichmäßig über alles verteilt, was dem Greifer begegnen kann, der als ein Typ benannt werden darf.</translation>
    </message>
    <message>
        <source>The false-reject rate holds</source>
        <translation>Die Fehlrückweisungsrate gilt</translation>
    </message>
    <message>
        <source>on average over libraries</source>
        <translation>im Mittel über Bibliotheken</translation>
    </message>
    <message>
        <source>for this library, with 95 % confidence (wider gates)</source>
        <translation>für diese Bibliothek, mit 95 % Vertrauen (breitere Grenzen)</translation>
    </message>
    <message>
        <source>Types spread unlike, or have wild squeezes among them (wider gates)</source>
        <translation>Typen streuen ungleich, haben Ausreißer (breitere Grenzen)</translation>
    </message>
    <message>
        <source>End a squeeze as soon as it is decided</source>
        <translation>Einen Druckversuch beenden, sobald er entschieden ist</translation>
    </message>
</context>
<context>
    <name>gripscope::RecipeWords</name>
    <message>
        <source>Four levels</source>
        <translation>Vier Stufen</translation>
    </message>
    <message>
        <source>Tells friction from stiffness; m is less certain.</source>
        <translation>Trennt Reibung von Steifigkeit; m ist unsicherer.</translation>
    </message>
    <message>
        <source>Two levels, slow sine</source>
        <translation>Zwei Stufen, langsamer Sinus</translation>
    </message>
    <message>
        <source>Tells friction best, and stiffness over all of its way.</source>
        <translation>Erkennt Reibung am besten, und Steifigkeit über den ganzen Weg.</translation>
    </message>
    <message>
        <source>Two levels, ramp and hold</source>
        <translation>Zwei Stufen, Rampe und Halten</translation>
    </message>
    <message>
        <source>Shows how far and how fast a part goes on yielding.</source>
        <translation>Zeigt, wie weit und wie schnell ein Teil weiter nachgibt.</translation>
    </message>
    <message>
        <source>Two levels</source>
        <translation>Zwei Stufen</translation>
    </message>
    <message>
        <source>Most certain where there is no friction, which hides in k.</source>
        <translation>Am sichersten ohne Reibung, die sonst in k steckt.</translation>
    </message>
    <message>
        <source>Repeating</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Sets noise apart; friction hides in k.</source>
        <translation>Trennt Rauschen ab; Reibung steckt in k.</translation>
    </message>
    <message>
        <source>Sum of sines</source>
        <translation>Summe von Sinus</translation>
    </message>
    <message>
        <source>Sees friction too, with less force on average.</source>
        <translation>Zeigt auch Reibung, mit im Mittel weniger Kraft.</translation>
    </message>
    <message>
        <source>Levels of your own</source>
        <translation>Eigene Stufen</translation>
    </message>
    <message>
        <source>As a file has them, or the designer.</source>
        <translation>So, wie eine Datei sie hat oder der Entwurf sie findet.</translation>
    </message>
</context>
<context>
    <name>gripscope::ReferenceCheckModel</name>
    <message>
        <source>Made</source>
        <translation>Gemacht</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>k, error</source>
        <translation>k, Fehler</translation>
    </message>
    <message>
        <source>b, error</source>
        <translation>b, Fehler</translation>
    </message>
    <message>
        <source>m, error</source>
        <translation>m, Fehler</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
</context>
<context>
    <name>gripscope::ReferenceDialog</name>
    <message>
        <source>Use this object</source>
        <translation>Dieses Objekt nehmen</translation>
    </message>
    <message>
        <source>Reference object</source>
        <translation>Referenzobjekt</translation>
    </message>
    <message>
        <source>for instance Spring S-12</source>
        <translation>zum Beispiel Feder S-12</translation>
    </message>
    <message>
        <source>number, if it has one</source>
        <translation>falls vorhanden</translation>
    </message>
    <message>
        <source>4 hours</source>
        <translation>4 Stunden</translation>
    </message>
    <message>
        <source>8 hours (a shift)</source>
        <translation>8 Stunden (eine Schicht)</translation>
    </message>
    <message>
        <source>24 hours</source>
        <translation>24 Stunden</translation>
    </message>
    <message>
        <source>a week</source>
        <translation>eine Woche</translation>
    </message>
    <message>
        <source>no check is asked for</source>
        <translation>keine Kontrolle verlangt</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Its certificate</source>
        <translation>Ihr Zertifikat</translation>
    </message>
    <message>
        <source>Stated</source>
        <translation>Angegeben</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>May differ by</source>
        <translation>Darf abweichen um</translation>
    </message>
    <message>
        <source>Preload</source>
        <translation>Vorlast</translation>
    </message>
    <message>
        <source>Push and release</source>
        <translation>Drücken und Nachlassen</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>A check holds for</source>
        <translation>Eine Kontrolle gilt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1, standard uncertainty</source>
        <translation>%1, Standardunsicherheit</translation>
    </message>
    <message>
        <source>%1, may differ by</source>
        <translation>%1, darf abweichen um</translation>
    </message>
</context>
<context>
    <name>gripscope::RegionPlot</name>
    <message>
        <source>95 % joint region of m, b and k</source>
        <translation>Gemeinsamer 95-%-Bereich von m, b und k</translation>
    </message>
    <message>
        <source>Correlation of %1 and %2: %3</source>
        <translation>Korrelation von %1 und %2: %L3</translation>
    </message>
    <message>
        <source>No region without an estimate and its error bars</source>
        <translation>Kein Bereich ohne Schätzung mit Fehlerbalken</translation>
    </message>
    <message>
        <source>95 % joint region, in % of the recommended m, b, k</source>
        <translation>Gemeinsamer 95-%-Bereich, in % der empfohlenen m, b, k</translation>
    </message>
    <message>
        <source>%1 (%)</source>
        <translation>%1 (%)</translation>
    </message>
    <message>
        <source>Joint region</source>
        <translation>Gemeinsamer Bereich</translation>
    </message>
    <message>
        <source>%1 outline: %2 (%)</source>
        <translation>%1 Umriss: %2 (%)</translation>
    </message>
    <message>
        <source>%1: m, b, k (%)</source>
        <translation>%1: m, b, k (%)</translation>
    </message>
</context>
<context>
    <name>gripscope::ReidentifyDialog</name>
    <message>
        <source>Identify again</source>
        <translation>Neu bestimmen</translation>
    </message>
    <message numerus="yes">
        <source>%n squeeze(s) with another estimator. Nothing that was stored changes: what you keep is stored beside it, with your name, and verdicts stay as they were.</source>
        <translation>
            <numerusform>%n Druckversuch mit einem anderen Schätzer. Nichts Gespeichertes ändert sich: Was behalten wird, steht mit Namen daneben, und Urteile bleiben.</numerusform>
            <numerusform>%n Druckversuche mit einem anderen Schätzer. Nichts Gespeichertes ändert sich: Was behalten wird, steht mit Namen daneben, und Urteile bleiben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stored and found now</source>
        <translation>Gespeichert und jetzt gefunden</translation>
    </message>
    <message>
        <source>Squeezes done</source>
        <translation>Erledigte Druckversuche</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>Force between samples</source>
        <translation>Kraftverlauf</translation>
    </message>
    <message>
        <source>Hold as recorded</source>
        <translation>Kraftverlauf wie aufgenommen</translation>
    </message>
    <message>
        <source>Force held</source>
        <translation>Kraft gehalten</translation>
    </message>
    <message>
        <source>Force straight</source>
        <translation>Kraft gerade</translation>
    </message>
    <message>
        <source>Start of the squeeze</source>
        <translation>Anfang des Druckversuchs</translation>
    </message>
    <message>
        <source>Free start</source>
        <translation>Freier Anfang</translation>
    </message>
    <message>
        <source>Starts at rest</source>
        <translation>Beginnt in Ruhe</translation>
    </message>
    <message>
        <source>Free offset</source>
        <translation>Freier Nullpunkt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Keep these estimates</source>
        <translation>Schätzungen behalten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message numerus="yes">
        <source>%n estimate(s) stored beside the first ones.</source>
        <translation>
            <numerusform>%n Schätzung neben den ersten gespeichert.</numerusform>
            <numerusform>%n Schätzungen neben den ersten gespeichert.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 done, m, b and k found in %3.</source>
        <translation>%1 von %2 erledigt, m, b und k in %3 gefunden.</translation>
    </message>
    <message>
        <source>The first line of a cell is what is stored, the second what is found now.</source>
        <translation>Die erste Zeile einer Zelle ist das Gespeicherte, die zweite das jetzt Gefundene.</translation>
    </message>
</context>
<context>
    <name>gripscope::ReidentifyJob</name>
    <message>
        <source>no recording was stored with it</source>
        <translation>ohne gespeicherte Aufnahme</translation>
    </message>
</context>
<context>
    <name>gripscope::ReidentifyModel</name>
    <message>
        <source>Squeeze</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>m: stored, now</source>
        <translation>m: alt, neu</translation>
    </message>
    <message>
        <source>b: stored, now</source>
        <translation>b: alt, neu</translation>
    </message>
    <message>
        <source>k: stored, now</source>
        <translation>k: alt, neu</translation>
    </message>
    <message>
        <source>Simulation fit</source>
        <translation>Simulationsfit</translation>
    </message>
</context>
<context>
    <name>gripscope::ReportTableModel</name>
    <message>
        <source>in</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>out</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>not taken</source>
        <translation>verweigert</translation>
    </message>
    <message>
        <source>feature</source>
        <translation>Feature</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Report</translation>
    </message>
    <message>
        <source>In words</source>
        <translation>In Worten</translation>
    </message>
</context>
<context>
    <name>gripscope::ReportsTab</name>
    <message>
        <source>Which reports</source>
        <translation>Welche Reports</translation>
    </message>
    <message>
        <source>All reports</source>
        <translation>Alle Reports</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Datenstrom</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Features</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>Beschädigte</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>The last reports</source>
        <translation>Die letzten Reports</translation>
    </message>
    <message>
        <source>The report&apos;s bytes</source>
        <translation>Die Bytes des Reports</translation>
    </message>
    <message>
        <source>Choose a report to read its bytes and fields</source>
        <translation>Einen Report wählen, um Bytes und Felder zu lesen</translation>
    </message>
    <message>
        <source>The report&apos;s fields</source>
        <translation>Die Felder des Reports</translation>
    </message>
    <message numerus="yes">
        <source>%n passed while this list was read</source>
        <translation>
            <numerusform>%n kam, während diese Liste gelesen wurde</numerusform>
            <numerusform>%n kamen, während diese Liste gelesen wurde</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gripscope::ResidualWords</name>
    <message>
        <source>white</source>
        <translation>weiß</translation>
    </message>
    <message>
        <source>modelled, not white</source>
        <translation>modelliert, nicht weiß</translation>
    </message>
    <message>
        <source>not white</source>
        <translation>nicht weiß</translation>
    </message>
    <message>
        <source>independent</source>
        <translation>unabhängig</translation>
    </message>
    <message>
        <source>dependent</source>
        <translation>abhängig</translation>
    </message>
</context>
<context>
    <name>gripscope::RestoreDialog</name>
    <message>
        <source>Put back a backup</source>
        <translation>Sicherung zurückspielen</translation>
    </message>
    <message>
        <source>Put back this backup?</source>
        <translation>Diese Sicherung zurückspielen?</translation>
    </message>
    <message>
        <source>It was verified: every row in it is as it was written.</source>
        <translation>Sie wurde nachgeprüft: Jede Zeile ist so, wie sie geschrieben wurde.</translation>
    </message>
    <message>
        <source>Why? The reason is kept in both libraries.</source>
        <translation>Warum? Der Grund wird in beiden Bibliotheken festgehalten.</translation>
    </message>
    <message>
        <source>Why it is put back</source>
        <translation>Warum sie zurückgespielt wird</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>Zurückspielen</translation>
    </message>
    <message>
        <source>In the backup</source>
        <translation>In der Sicherung</translation>
    </message>
    <message>
        <source>In the library now</source>
        <translation>Jetzt in der Bibliothek</translation>
    </message>
    <message>
        <source>Inspections</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Druckversuche</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>Kalibrierungen</translation>
    </message>
    <message>
        <source>Entries of the audit trail</source>
        <translation>Einträge im Änderungsprotokoll</translation>
    </message>
    <message>
        <source>Stored last</source>
        <translation>Zuletzt gespeichert</translation>
    </message>
</context>
<context>
    <name>gripscope::ResultText</name>
    <message>
        <source>%1 = %2 (no interval)</source>
        <translation>%1 = %2 (kein Intervall)</translation>
    </message>
    <message>
        <source>%1: at most %2</source>
        <translation>%1: höchstens %2</translation>
    </message>
    <message>
        <source>%1 = %2 (%3 to %4)</source>
        <translation>%1 = %2 (%3 bis %4)</translation>
    </message>
    <message>
        <source>The measurement is valid.</source>
        <translation>Die Messung ist gültig.</translation>
    </message>
    <message>
        <source>The measurement is suspect.</source>
        <translation>Die Messung ist fraglich.</translation>
    </message>
    <message>
        <source>The measurement is not valid.</source>
        <translation>Die Messung ist ungültig.</translation>
    </message>
    <message>
        <source>%1, %2, 95 % intervals</source>
        <translation>%1, %2, 95-%-Intervalle</translation>
    </message>
    <message>
        <source>%1: at least %2</source>
        <translation>%1: mindestens %2</translation>
    </message>
</context>
<context>
    <name>gripscope::SceneToolBar</name>
    <message>
        <source>This library</source>
        <translation>Diese Bibliothek</translation>
    </message>
    <message>
        <source>The paper&apos;s tables (units as printed)</source>
        <translation>Tabellen der Veröffentlichung (Einheiten wie gedruckt)</translation>
    </message>
    <message>
        <source>Which types to show</source>
        <translation>Welche Typen zu zeigen sind</translation>
    </message>
    <message>
        <source>Look along the mass axis (M)</source>
        <translation>Entlang der Massenachse blicken (M)</translation>
    </message>
    <message>
        <source>Look along the damping axis (B)</source>
        <translation>Entlang der Dämpfungsachse blicken (B)</translation>
    </message>
    <message>
        <source>Look along the stiffness axis (K)</source>
        <translation>Entlang der Steifigkeitsachse blicken (K)</translation>
    </message>
    <message>
        <source>The whole space from its corner (I)</source>
        <translation>Der ganze Raum von seiner Ecke aus (I)</translation>
    </message>
    <message>
        <source>Orthographic instead of perspective (O)</source>
        <translation>Parallel- statt Zentralprojektion (O)</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save the picture…</source>
        <translation>Bild speichern…</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>the picture could not be written</source>
        <translation>das Bild ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>View along</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Picture as it is rendered, as PNG…</source>
        <translation>Bild wie dargestellt, als PNG…</translation>
    </message>
</context>
<context>
    <name>gripscope::SceneView</name>
    <message>
        <source>Types in the space of mass, damping and stiffness</source>
        <translation>Typen im Raum von Masse, Dämpfung und Steifigkeit</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>Space of m, b and k</source>
        <translation>Raum von m, b und k</translation>
    </message>
</context>
<context>
    <name>gripscope::SelfTestTab</name>
    <message>
        <source>Test the gripper</source>
        <translation>Greifer prüfen</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>Two seconds of listening, then a stop. Nothing moves; the gripper is disarmed at the end.</source>
        <translation>Zwei Sekunden Zuhören, dann ein Stopp. Nichts bewegt sich; am Ende ist der Greifer entschärft.</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Erlaubt</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Listening…</source>
        <translation>Hört zu…</translation>
    </message>
    <message>
        <source>Nothing wrong was found.</source>
        <translation>Kein Fehler gefunden.</translation>
    </message>
    <message>
        <source>Something is wrong: see the lines with a cross.</source>
        <translation>Etwas stimmt nicht: siehe die Zeilen mit Kreuz.</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>nicht geprüft</translation>
    </message>
</context>
<context>
    <name>gripscope::ServerDialog</name>
    <message>
        <source>Open a library on a server</source>
        <translation>Bibliothek auf einem Server öffnen</translation>
    </message>
    <message>
        <source>Address of the PostgreSQL database</source>
        <translation>Adresse der PostgreSQL-Datenbank</translation>
    </message>
    <message>
        <source>The password is not part of it: it is read from the file .pgpass of your home folder.</source>
        <translation>Das Passwort gehört nicht dazu: es wird aus der Datei .pgpass Ihres Home-Verzeichnisses gelesen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
</context>
<context>
    <name>gripscope::Setting</name>
    <message>
        <source>%1 From the next connection on.</source>
        <translation>%1 Ab der nächsten Verbindung.</translation>
    </message>
    <message>
        <source>%1 From the next start on.</source>
        <translation>%1 Ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>0, or a number from %1 to %2</source>
        <translation>0 oder eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a text of up to %1 letters</source>
        <translation>ein Text von bis zu %1 Zeichen</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Inspecting</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Fehlerraten</translation>
    </message>
    <message>
        <source>Kept sessions</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Beim Start</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of all words and numbers on the screen.</source>
        <translation>Aller Wörter und Zahlen auf dem Bildschirm.</translation>
    </message>
    <message>
        <source>Text and control size</source>
        <translation>Größe von Text und Bedienelementen</translation>
    </message>
    <message>
        <source>Enlarges everything in the window.</source>
        <translation>Vergrößert alles im Fenster.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Colours of the window.</source>
        <translation>Farben des Fensters.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Sound on a verdict</source>
        <translation>Ton beim Urteil</translation>
    </message>
    <message>
        <source>A beep when an inspection is decided.</source>
        <translation>Ein Piepton, wenn eine Prüfung entschieden ist.</translation>
    </message>
    <message>
        <source>End a squeeze as soon as it is decided</source>
        <translation>Einen Druckversuch beenden, sobald er entschieden ist</translation>
    </message>
    <message>
        <source>Parts that are clear take less time; the rates still hold.</source>
        <translation>Eindeutige Teile brauchen weniger Zeit; die Fehlerraten gelten weiterhin.</translation>
    </message>
    <message>
        <source>The false-reject rate holds</source>
        <translation>Die Fehlrückweisungsrate gilt</translation>
    </message>
    <message>
        <source>With confidence for this library, gates are wider.</source>
        <translation>Mit Vertrauen für diese Bibliothek sind die Grenzen breiter.</translation>
    </message>
    <message>
        <source>on average over libraries</source>
        <translation>im Mittel über Bibliotheken</translation>
    </message>
    <message>
        <source>with 95 % confidence</source>
        <translation>mit 95 % Vertrauen</translation>
    </message>
    <message>
        <source>Types spread unlike</source>
        <translation>Typen streuen ungleich</translation>
    </message>
    <message>
        <source>Or have wild squeezes among them: allows for both by wider gates.</source>
        <translation>Oder enthalten Ausreißer: berücksichtigt beides durch breitere Grenzen.</translation>
    </message>
    <message>
        <source>False-reject rate</source>
        <translation>Fehlrückweisungsrate</translation>
    </message>
    <message>
        <source>Share of squeezes of enrolled types that may be called unknown.</source>
        <translation>Anteil der Druckversuche eingelernter Typen, der unbekannt heißen darf.</translation>
    </message>
    <message>
        <source>Wrong-type rate</source>
        <translation>Verwechslungsrate</translation>
    </message>
    <message>
        <source>Share of squeezes of enrolled types that may be named another type.</source>
        <translation>Anteil der Druckversuche eingelernter Typen, der als anderer Typ benannt werden darf.</translation>
    </message>
    <message>
        <source>Stranger-accept rate</source>
        <translation>Fremdannahmerate</translation>
    </message>
    <message>
        <source>Share of parts of no enrolled type that may be named a type.</source>
        <translation>Anteil der Teile keines eingelernten Typs, der als ein Typ benannt werden darf.</translation>
    </message>
    <message>
        <source>Keep the raw reports of every session</source>
        <translation>Rohdaten jeder Sitzung aufbewahren</translation>
    </message>
    <message>
        <source>So that it can be replayed. Of real grippers only.</source>
        <translation>Damit sie sich wiedergeben lässt. Nur von echten Greifern.</translation>
    </message>
    <message>
        <source>Folder of kept sessions</source>
        <translation>Ordner der Aufzeichnungen</translation>
    </message>
    <message>
        <source>Empty: the usual folder for data.</source>
        <translation>Leer: der übliche Ordner für Daten.</translation>
    </message>
    <message>
        <source>Room for kept sessions</source>
        <translation>Platz für Aufzeichnungen</translation>
    </message>
    <message>
        <source>When it is full, the oldest make room.</source>
        <translation>Ist er voll, machen die ältesten Platz.</translation>
    </message>
    <message>
        <source>Connect at the start</source>
        <translation>Beim Start verbinden</translation>
    </message>
    <message>
        <source>The gripper that Gripscope looks for by itself.</source>
        <translation>Der Greifer, den Gripscope von selbst sucht.</translation>
    </message>
    <message>
        <source>The one used last</source>
        <translation>Der zuletzt benutzte</translation>
    </message>
    <message>
        <source>The virtual gripper</source>
        <translation>Der virtuelle Greifer</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Example types</source>
        <translation>Beispieltypen</translation>
    </message>
    <message>
        <source>Adds the four example types to the library.</source>
        <translation>Fügt der Bibliothek die vier Beispieltypen hinzu.</translation>
    </message>
    <message>
        <source>Gripper used last</source>
        <translation>Zuletzt benutzter Greifer</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Sign out when nobody works</source>
        <translation>Abmelden, wenn niemand arbeitet</translation>
    </message>
    <message>
        <source>After so many minutes without a key or a click.</source>
        <translation>Nach so vielen Minuten ohne Taste oder Klick.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Disarm when nothing is done</source>
        <translation>Entschärfen, wenn nichts getan wird</translation>
    </message>
    <message>
        <source>After so many minutes without a key, a click, a scan or a squeeze.</source>
        <translation>Nach so vielen Minuten ohne Taste, Klick, Scan oder Druckversuch.</translation>
    </message>
    <message>
        <source>What STOP is was read</source>
        <translation>Gelesen, was STOPP ist</translation>
    </message>
    <message>
        <source>Refuse to judge when a calibration is overdue</source>
        <translation>Nicht beurteilen, wenn eine Kalibrierung überfällig ist</translation>
    </message>
    <message>
        <source>Otherwise such a measurement is suspect.</source>
        <translation>Sonst ist eine solche Messung fraglich.</translation>
    </message>
    <message>
        <source>Refuse to judge when more samples are lost</source>
        <translation>Nicht beurteilen, wenn mehr Abtastwerte verloren gehen</translation>
    </message>
    <message>
        <source>Share of a squeeze&apos;s samples. Otherwise such a measurement is suspect.</source>
        <translation>Anteil an den Abtastwerten eines Druckversuchs. Sonst ist eine solche Messung fraglich.</translation>
    </message>
    <message>
        <source>Refuse to judge when nobody is signed in</source>
        <translation>Nicht beurteilen, wenn niemand angemeldet ist</translation>
    </message>
    <message>
        <source>Where the library has people.</source>
        <translation>In Bibliotheken mit Personen.</translation>
    </message>
    <message>
        <source>Call the supervisor</source>
        <translation>Aufsicht rufen</translation>
    </message>
    <message>
        <source>After so many squeezes in a row that were not valid.</source>
        <translation>Nach so vielen ungültigen Druckversuchen in Folge.</translation>
    </message>
    <message>
        <source>Part numbers</source>
        <translation>Teilenummern</translation>
    </message>
    <message>
        <source>A scanned code that is no type&apos;s is the number of the next part.</source>
        <translation>Ein gescannter Code, den kein Typ hat, ist die Nummer des nächsten Teils.</translation>
    </message>
    <message>
        <source>Expected type</source>
        <translation>Erwarteter Typ</translation>
    </message>
    <message>
        <source>Begin of the shift</source>
        <translation>Beginn der Schicht</translation>
    </message>
    <message>
        <source>Squeeze by itself when a part arrives</source>
        <translation>Von selbst drücken, wenn ein Teil kommt</translation>
    </message>
    <message>
        <source>Only armed, on the Inspect page, 2 s after the force has changed last, with a countdown that is seen and heard.</source>
        <translation>Nur scharf, auf der Seite Prüfen, 2 s nach der letzten Änderung der Kraft, mit einem sichtbaren und hörbaren Countdown.</translation>
    </message>
    <message>
        <source>A part has arrived</source>
        <translation>Ein Teil ist da</translation>
    </message>
    <message>
        <source>When the force rises by so many times its own noise at rest.</source>
        <translation>Wenn die Kraft um so viele Male ihr eigenes Rauschen in Ruhe steigt.</translation>
    </message>
    <message>
        <source>Unit of force</source>
        <translation>Einheit der Kraft</translation>
    </message>
    <message>
        <source>On the screen and in reports; damping and stiffness follow, and masses are in lb with lbf.</source>
        <translation>Auf dem Bildschirm und in Berichten; Dämpfung und Steifigkeit folgen, und bei lbf stehen Massen in lb.</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Einheit der Länge</translation>
    </message>
    <message>
        <source>On the screen and in reports; CSV and JSON files stay in the units that they were recorded in.</source>
        <translation>Auf dem Bildschirm und in Berichten; CSV- und JSON-Dateien bleiben in den Einheiten der Aufzeichnung.</translation>
    </message>
    <message>
        <source>Reports and certificates</source>
        <translation>Berichte und Zertifikate</translation>
    </message>
    <message>
        <source>Company</source>
        <translation>Firma</translation>
    </message>
    <message>
        <source>At the head of reports and certificates.</source>
        <translation>Am Kopf von Berichten und Zertifikaten.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Anschrift</translation>
    </message>
    <message>
        <source>Below the name; a semicolon begins a new line.</source>
        <translation>Unter dem Namen; ein Semikolon beginnt eine neue Zeile.</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>A PNG or SVG file of up to 2 MB. Empty: none.</source>
        <translation>Eine PNG- oder SVG-Datei bis 2 MB. Leer: keines.</translation>
    </message>
    <message>
        <source>Local gravity</source>
        <translation>Örtliche Fallbeschleunigung</translation>
    </message>
    <message>
        <source>By which reference masses in kg or lb are taken for forces.</source>
        <translation>Mit ihr werden Referenzmassen in kg oder lb zu Kräften.</translation>
    </message>
    <message>
        <source>Studies of the gripper</source>
        <translation>Studien des Greifers</translation>
    </message>
    <message>
        <source>Months for which a study holds that is begun from now on.</source>
        <translation>So viele Monate gilt eine Studie, die ab jetzt begonnen wird.</translation>
    </message>
    <message>
        <source>Type-1 study is due again</source>
        <translation>Typ-1-Studie wieder fällig</translation>
    </message>
    <message>
        <source>Gauge study is due again</source>
        <translation>Messmittelstudie wieder fällig</translation>
    </message>
    <message>
        <source>Linearity study is due again</source>
        <translation>Linearitätsstudie wieder fällig</translation>
    </message>
    <message>
        <source>Attribute study is due again</source>
        <translation>Attributive Studie wieder fällig</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>A PLC may trigger squeezes</source>
        <translation>Eine SPS darf Druckversuche auslösen</translation>
    </message>
    <message>
        <source>By Modbus TCP, of a gripper that a person has armed. The register map is in the manual.</source>
        <translation>Über Modbus TCP, an einem Greifer, den eine Person scharf geschaltet hat. Die Registertabelle steht im Handbuch.</translation>
    </message>
    <message>
        <source>Listens on</source>
        <translation>Hört auf</translation>
    </message>
    <message>
        <source>A network address of this computer. Empty: 127.0.0.1, which no other computer reaches.</source>
        <translation>Eine Netzadresse dieses Rechners. Leer: 127.0.0.1, die kein anderer Rechner erreicht.</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>502 needs a right that programs usually lack.</source>
        <translation>502 braucht ein Recht, das Programme meist nicht haben.</translation>
    </message>
    <message>
        <source>Who may connect</source>
        <translation>Wer sich verbinden darf</translation>
    </message>
    <message>
        <source>Addresses and networks such as 10.1.2.0/24, parted by semicolons; this computer always may.</source>
        <translation>Adressen und Netze wie 10.1.2.0/24, durch Semikolon getrennt; dieser Rechner darf immer.</translation>
    </message>
    <message>
        <source>Types by number</source>
        <translation>Typen nach Nummer</translation>
    </message>
    <message>
        <source>Their names, parted by semicolons: the first is the PLC&apos;s type 1.</source>
        <translation>Ihre Namen, durch Semikolon getrennt: Der erste ist Typ 1 der SPS.</translation>
    </message>
    <message>
        <source>The PLC is lost</source>
        <translation>Die SPS gilt als verloren</translation>
    </message>
    <message>
        <source>When its heartbeat stands still for so long: the gripper is then stopped and disarmed.</source>
        <translation>Wenn ihr Lebenszeichen so lange stillsteht: Der Greifer wird dann gestoppt und entschärft.</translation>
    </message>
    <message>
        <source>Send every result to a broker</source>
        <translation>Jedes Ergebnis an einen Broker senden</translation>
    </message>
    <message>
        <source>Over MQTT. What the broker cannot take yet waits beside the library.</source>
        <translation>Über MQTT. Was der Broker noch nicht nehmen kann, wartet neben der Bibliothek.</translation>
    </message>
    <message>
        <source>Broker</source>
        <translation>Broker</translation>
    </message>
    <message>
        <source>Its name or address, with a port where that is not 1883, or 8883 over TLS: broker.example:1883.</source>
        <translation>Sein Name oder seine Adresse, mit Port, wo er nicht 1883 oder über TLS 8883 ist: broker.example:1883.</translation>
    </message>
    <message>
        <source>Over TLS</source>
        <translation>Über TLS</translation>
    </message>
    <message>
        <source>Without it, the password and all results cross the network in the clear.</source>
        <translation>Ohne TLS gehen Passwort und Ergebnisse offen durch das Netz.</translation>
    </message>
    <message>
        <source>Authority of its certificate</source>
        <translation>Aussteller seines Zertifikats</translation>
    </message>
    <message>
        <source>A PEM file. Empty: one of the authorities that this computer trusts.</source>
        <translation>Eine PEM-Datei. Leer: ein Aussteller, dem dieser Rechner vertraut.</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Who the station is for the broker. Empty: nobody.</source>
        <translation>Wer die Station für den Broker ist. Leer: niemand.</translation>
    </message>
    <message>
        <source>File with the password</source>
        <translation>Datei mit dem Passwort</translation>
    </message>
    <message>
        <source>Its first line is the password; nobody but its owner may read it.</source>
        <translation>Ihre erste Zeile ist das Passwort; nur ihr Besitzer darf sie lesen.</translation>
    </message>
    <message>
        <source>Topic of JSON</source>
        <translation>Topic für JSON</translation>
    </message>
    <message>
        <source>A message a result, such as plant/results. Empty: no JSON.</source>
        <translation>Eine Nachricht je Ergebnis, etwa plant/results. Leer: kein JSON.</translation>
    </message>
    <message>
        <source>Sparkplug group and node</source>
        <translation>Gruppe und Knoten von Sparkplug</translation>
    </message>
    <message>
        <source>As GROUP/NODE, unlike that of any other station. Empty: no Sparkplug B.</source>
        <translation>Als GRUPPE/KNOTEN, anders als bei jeder anderen Station. Leer: kein Sparkplug B.</translation>
    </message>
    <message>
        <source>Primary host</source>
        <translation>Primärer Host</translation>
    </message>
    <message>
        <source>Results wait while this host of Sparkplug is not online. Empty: for none.</source>
        <translation>Ergebnisse warten, solange dieser Host von Sparkplug nicht online ist. Leer: auf keinen.</translation>
    </message>
    <message>
        <source>Results to a broker (MQTT)</source>
        <translation>Ergebnisse an einen Broker (MQTT)</translation>
    </message>
    <message>
        <source>In step with the server</source>
        <translation>Abgeglichen mit dem Server</translation>
    </message>
    <message>
        <source>The plant&apos;s library: postgresql://USER@HOST/NAME. What is stored here goes there, types and calibrations of the plant come from there. Empty: with none.</source>
        <translation>Die Bibliothek des Werks: postgresql://USER@HOST/NAME. Was hier gespeichert wird, geht dorthin; Typen und Kalibrierungen des Werks kommen von dort. Leer: mit keinem.</translation>
    </message>
    <message>
        <source>Library of the plant</source>
        <translation>Bibliothek des Werks</translation>
    </message>
    <message>
        <source>The plant&apos;s library is on a server: postgresql://USER@HOST/NAME.</source>
        <translation>Die Bibliothek des Werks ist auf einem Server: postgresql://USER@HOST/NAME.</translation>
    </message>
    <message>
        <source>Name the broker alone, such as broker.example:1883. User and password have places of their own.</source>
        <translation>Nur den Broker nennen, etwa broker.example:1883. Benutzer und Passwort haben ihre eigenen Stellen.</translation>
    </message>
    <message>
        <source>%1 takes %2.</source>
        <translation>%1: erwartet wird %2.</translation>
    </message>
</context>
<context>
    <name>gripscope::SettingRow</name>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>Zurück zum Vorgabewert: %1</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation>Bilder (*.png *.svg)</translation>
    </message>
</context>
<context>
    <name>gripscope::Settings</name>
    <message>
        <source>The settings in %1 cannot be read. The defaults are used; what you change now may not be kept. Check that file.</source>
        <translation>Die Einstellungen in %1 lassen sich nicht lesen. Es gelten die Vorgabewerte; was jetzt geändert wird, bleibt vielleicht nicht erhalten. Diese Datei prüfen.</translation>
    </message>
    <message>
        <source>The setting &quot;%1&quot; was stored as &quot;%2&quot;, which cannot be used: expected %3. It is back at its default, %4.</source>
        <translation>Die Einstellung „%1“ war als „%2“ gespeichert, was nicht brauchbar ist: erwartet wird %3. Es gilt wieder der Vorgabewert, %4.</translation>
    </message>
</context>
<context>
    <name>gripscope::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation>Einstellungen durchsuchen</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>Keine Einstellung enthält diese Wörter.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Reset all…</source>
        <translation>Alle zurücksetzen…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Export the settings</source>
        <translation>Einstellungen exportieren</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Einstellungen importieren</translation>
    </message>
    <message>
        <source>Settings (*.json)</source>
        <translation>Einstellungen (*.json)</translation>
    </message>
    <message>
        <source>The settings were written to %1.</source>
        <translation>Die Einstellungen wurden nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>%1 Nothing was changed.</source>
        <translation>%1 Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The settings were taken from %1.</source>
        <translation>Die Einstellungen wurden aus %1 übernommen.</translation>
    </message>
    <message>
        <source>Reset all settings</source>
        <translation>Alle Einstellungen zurücksetzen</translation>
    </message>
    <message>
        <source>All settings go back to their defaults. Types, squeezes and calibrations are not touched.</source>
        <translation>Alle Einstellungen gehen auf ihre Vorgabewerte zurück. Typen, Druckversuche und Kalibrierungen bleiben unberührt.</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>gripscope::SettingsExchange</name>
    <message>
        <source>a list or an object</source>
        <translation>eine Liste oder ein Objekt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no setting of this version and is passed over.</source>
        <translation>„%1“ ist keine Einstellung dieser Version und wird übergangen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to one computer and is passed over.</source>
        <translation>„%1“ gehört zu einem einzelnen Rechner und wird übergangen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; (%2) is %3; expected %4.</source>
        <translation>„%1“ (%2) ist %3; erwartet wird %4.</translation>
    </message>
    <message>
        <source>expected settings that Gripscope exported</source>
        <translation>erwartet: von Gripscope exportierte Einstellungen</translation>
    </message>
    <message>
        <source>a document of another kind</source>
        <translation>ein Dokument anderer Art</translation>
    </message>
    <message>
        <source>version %1 of the format</source>
        <translation>Version %1 des Formats</translation>
    </message>
    <message>
        <source>expected version %1; a newer Gripscope reads newer ones</source>
        <translation>erwartet: Version %1; ein neueres Gripscope liest neuere</translation>
    </message>
</context>
<context>
    <name>gripscope::SignIn</name>
    <message>
        <source>%1 was signed out: nobody has done anything here for a while.</source>
        <translation>%1 wurde abgemeldet: Hier hat eine Weile niemand etwas getan.</translation>
    </message>
    <message>
        <source>Sign in, then arm the gripper: the library keeps who armed it.</source>
        <translation>Erst anmelden, dann scharf schalten: Die Bibliothek hält fest, wer es war.</translation>
    </message>
</context>
<context>
    <name>gripscope::SignInDialog</name>
    <message>
        <source>PIN or password</source>
        <translation>PIN oder Passwort</translation>
    </message>
    <message>
        <source>Authorise</source>
        <translation>Genehmigen</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Supervisor needed</source>
        <translation>Aufsicht nötig</translation>
    </message>
    <message>
        <source>Supervisor</source>
        <translation>Aufsicht</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>A supervisor allows this one time. It is kept with both names.</source>
        <translation>Eine Aufsicht erlaubt dies ein Mal. Beide Namen werden festgehalten.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>gripscope::SoundButton</name>
    <message>
        <source>Sound on</source>
        <translation>Ton an</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Ton aus</translation>
    </message>
    <message>
        <source>Each verdict is heard. Click to switch the sound off.</source>
        <translation>Jedes Urteil ist zu hören. Klicken schaltet den Ton aus.</translation>
    </message>
    <message>
        <source>Verdicts are silent. Click to switch the sound on.</source>
        <translation>Urteile sind stumm. Klicken schaltet den Ton an.</translation>
    </message>
</context>
<context>
    <name>gripscope::SpaceClustering</name>
    <message>
        <source>Clusters need at least two squeezes. Enrol some more.</source>
        <translation>Cluster brauchen mindestens zwei Druckversuche. Weitere einlernen.</translation>
    </message>
    <message>
        <source>%1 clusters need at least %1 squeezes; there are %2. Ask for fewer clusters, or enrol more squeezes.</source>
        <translation>%1 Cluster brauchen mindestens %1 Druckversuche; es sind %2. Weniger Cluster verlangen oder mehr Druckversuche einlernen.</translation>
    </message>
    <message>
        <source>The squeezes are so much alike that all fell into one cluster.</source>
        <translation>Die Druckversuche sind einander so ähnlich, dass alle in einen Cluster fielen.</translation>
    </message>
    <message>
        <source>Only %1 of the %2 clusters hold squeezes: there are no more groups to be found.</source>
        <translation>Nur %1 der %2 Cluster enthalten Druckversuche: Mehr Gruppen sind nicht zu finden.</translation>
    </message>
    <message>
        <source>Not at rest after %1 iterations: take it with care.</source>
        <translation>Nach %1 Iterationen nicht konvergiert: mit Vorsicht verwenden.</translation>
    </message>
    <message>
        <source>inertia %1</source>
        <translation>Trägheit %1</translation>
    </message>
    <message>
        <source>log-likelihood %1</source>
        <translation>Log-Likelihood %1</translation>
    </message>
    <message>
        <source>quantisation error %1</source>
        <translation>Quantisierungsfehler %1</translation>
    </message>
</context>
<context>
    <name>gripscope::StationConflicts</name>
    <message>
        <source>Stations decided apart, which a supervisor is to look at (Library…): %1</source>
        <translation>Stationen haben getrennt entschieden, was die Aufsicht ansehen soll (Bibliothek…): %1</translation>
    </message>
    <message>
        <source>I have seen it</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>Stations decided apart</source>
        <translation>Getrennt entschieden</translation>
    </message>
    <message numerus="yes">
        <source>And %n more, in the audit trail.</source>
        <translation>
            <numerusform>Und %n weiterer im Änderungsprotokoll.</numerusform>
            <numerusform>Und %n weitere im Änderungsprotokoll.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gripscope::StatusLine</name>
    <message>
        <source>armed: %1</source>
        <translation>scharf: %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>latency %1 ms</source>
        <translation>Latenz %1 ms</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>library %1</source>
        <translation>Bibliothek %1</translation>
    </message>
    <message>
        <source>1 type</source>
        <translation>1 Typ</translation>
    </message>
    <message numerus="yes">
        <source>%n types</source>
        <translation>
            <numerusform>%n Typ</numerusform>
            <numerusform>%n Typen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inspected</source>
        <translation>%1 geprüft</translation>
    </message>
    <message>
        <source>library %1 v%2</source>
        <translation>Bibliothek %1 v%2</translation>
    </message>
    <message>
        <source>stopped: not armed</source>
        <translation>angehalten: nicht scharf</translation>
    </message>
</context>
<context>
    <name>gripscope::StepBar</name>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>Clusters</source>
        <translation>Cluster</translation>
    </message>
    <message>
        <source>Play the iterations</source>
        <translation>Die Iterationen abspielen</translation>
    </message>
    <message>
        <source>One iteration back</source>
        <translation>Eine Iteration zurück</translation>
    </message>
    <message>
        <source>One iteration on</source>
        <translation>Eine Iteration weiter</translation>
    </message>
    <message>
        <source>Colour by type, with the ellipsoid that holds 95 % of its squeezes</source>
        <translation>Farbe nach Typ, mit dem Ellipsoid, das 95 % seiner Druckversuche enthält</translation>
    </message>
    <message>
        <source>Colour by the clusters that are found without knowing the types</source>
        <translation>Farbe nach den Clustern, die ohne Kenntnis der Typen gefunden wurden</translation>
    </message>
    <message>
        <source>Iteration of the method</source>
        <translation>Iteration des Verfahrens</translation>
    </message>
    <message>
        <source>start of %1</source>
        <translation>Beginn von %1</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
</context>
<context>
    <name>gripscope::StepLine</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>All steps done</source>
        <translation>Alle Schritte erledigt</translation>
    </message>
</context>
<context>
    <name>gripscope::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Stop the gripper and disarm it</source>
        <translation>Den Greifer anhalten und entschärfen</translation>
    </message>
    <message>
        <source>Stop the gripper and disarm it (Esc)</source>
        <translation>Den Greifer anhalten und entschärfen (Esc)</translation>
    </message>
</context>
<context>
    <name>gripscope::StopStrip</name>
    <message>
        <source>The gripper is squeezing.</source>
        <translation>Der Greifer drückt.</translation>
    </message>
    <message>
        <source>The gripper is armed: it may move.</source>
        <translation>Der Greifer ist scharf: Er kann sich bewegen.</translation>
    </message>
    <message>
        <source>Stopped. The gripper is not armed.</source>
        <translation>Angehalten. Der Greifer ist nicht scharfgeschaltet.</translation>
    </message>
    <message>
        <source>The gripper is not armed.</source>
        <translation>Der Greifer ist nicht scharfgeschaltet.</translation>
    </message>
</context>
<context>
    <name>gripscope::StripChart</name>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
</context>
<context>
    <name>gripscope::StudyForm</name>
    <message>
        <source>Name of the study</source>
        <translation>Name der Studie</translation>
    </message>
    <message>
        <source>1, 2, 3 … unless parts have labels of their own</source>
        <translation>1, 2, 3 …, wenn Teile keine eigenen haben</translation>
    </message>
    <message>
        <source>Names, with commas between them</source>
        <translation>Namen, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>One operator after the other</source>
        <translation>Ein Bediener nach dem anderen</translation>
    </message>
    <message>
        <source>Trial after trial</source>
        <translation>Durchgang für Durchgang</translation>
    </message>
    <message>
        <source>All mixed</source>
        <translation>Alles gemischt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Kennzeichen</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Referenzen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Squeezed as</source>
        <translation>Gedrückt wie</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Tolerance of %1</source>
        <translation>Toleranz von %1</translation>
    </message>
    <message>
        <source>From the lower to the upper limit of the product; may stay unstated</source>
        <translation>Von der unteren zur oberen Grenze des Produkts; kann offen bleiben</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Begin the study (Enter)</source>
        <translation>Studie beginnen (Enter)</translation>
    </message>
    <message>
        <source>A new type: %1</source>
        <translation>Ein neuer Typ: %1</translation>
    </message>
    <message>
        <source>Parts of %1: %2</source>
        <translation>Teile von %1: %2</translation>
    </message>
    <message>
        <source>Give the study a name.</source>
        <translation>Der Studie einen Namen geben.</translation>
    </message>
    <message>
        <source>State the tolerance that the part&apos;s quantity has: the gripper is measured against it.</source>
        <translation>Die Toleranz der Größe angeben: An ihr wird der Greifer gemessen.</translation>
    </message>
    <message>
        <source>%1 verdicts in random order. Nobody sees what was said before.</source>
        <translation>%1 Urteile in zufälliger Reihenfolge. Niemand sieht, was vorher gesagt wurde.</translation>
    </message>
    <message>
        <source>%1 squeezes in random order. Nobody sees a result before the end.</source>
        <translation>%1 Druckversuche in zufälliger Reihenfolge. Niemand sieht vor dem Ende ein Ergebnis.</translation>
    </message>
    <message>
        <source>The right word for each part, with semicolons between; may stay empty</source>
        <translation>Das richtige Wort für jedes Teil, durch Semikolons getrennt; kann leer bleiben</translation>
    </message>
    <message>
        <source>What the part is, in %1</source>
        <translation>Wert des Teils, in %1</translation>
    </message>
    <message>
        <source>What each part is, in %1, with semicolons between</source>
        <translation>Wert jedes Teils, in %1, durch Semikolons getrennt</translation>
    </message>
</context>
<context>
    <name>gripscope::StudyLead</name>
    <message>
        <source>Arm the gripper</source>
        <translation>Greifer scharf schalten</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Kennzeichen</translation>
    </message>
    <message>
        <source>typed or scanned, then Enter</source>
        <translation>tippen oder scannen</translation>
    </message>
    <message>
        <source>Label of the part between the fingers</source>
        <translation>Kennzeichen des Teils zwischen den Fingern</translation>
    </message>
    <message>
        <source>Ask for it each time</source>
        <translation>Jedes Mal danach fragen</translation>
    </message>
    <message>
        <source>No part is squeezed before its label was typed or scanned</source>
        <translation>Kein Teil wird gedrückt, bevor sein Kennzeichen getippt oder gescannt ist</translation>
    </message>
    <message>
        <source>or another word, then Enter</source>
        <translation>oder ein anderes Wort, dann Enter</translation>
    </message>
    <message>
        <source>What the part is called</source>
        <translation>Wie das Teil genannt wird</translation>
    </message>
    <message>
        <source>Take the last one back (Ctrl+Z)</source>
        <translation>Letzten zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Leave this one out…</source>
        <translation>Dieses auslassen …</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Goes back to the list; the study is kept and can be gone on with</source>
        <translation>Zurück zur Liste; die Studie bleibt und kann fortgesetzt werden</translation>
    </message>
    <message>
        <source>End it here…</source>
        <translation>Hier beenden …</translation>
    </message>
    <message>
        <source>All squeezes are through</source>
        <translation>Alle Druckversuche sind gemacht</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Als Nächstes</translation>
    </message>
    <message>
        <source>Operator %1</source>
        <translation>Bediener %1</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>Teil %1</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>%1, at station %2</source>
        <translation>%1, an Station %2</translation>
    </message>
    <message>
        <source>Squeezing…</source>
        <translation>Drückt…</translation>
    </message>
    <message>
        <source>Finding m, b and k…</source>
        <translation>m, b und k werden bestimmt…</translation>
    </message>
    <message>
        <source>Being stored…</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Nothing can be taken back once the result is shown.</source>
        <translation>Sobald das Ergebnis gezeigt ist, kann nichts mehr zurückgenommen werden.</translation>
    </message>
    <message>
        <source>Look at part %1 and say what it is.</source>
        <translation>Teil %1 ansehen und sagen, was es ist.</translation>
    </message>
    <message>
        <source>Put part %1 between the fingers, hands clear, then arm.</source>
        <translation>Teil %1 zwischen die Finger legen, Hände weg, dann schärfen.</translation>
    </message>
    <message>
        <source>Put part %1 between the fingers, then type or scan its label.</source>
        <translation>Teil %1 zwischen die Finger legen, dann sein Kennzeichen tippen oder scannen.</translation>
    </message>
    <message>
        <source>Put part %1 between the fingers, hands clear, then press Space.</source>
        <translation>Teil %1 zwischen die Finger legen, Hände weg, dann die Leertaste drücken.</translation>
    </message>
    <message>
        <source>Finish and show the result</source>
        <translation>Beenden und Ergebnis zeigen</translation>
    </message>
    <message>
        <source>Squeeze (Space)</source>
        <translation>Drücken (Leertaste)</translation>
    </message>
    <message>
        <source>That squeeze does not count: %1 Squeeze the same part again.</source>
        <translation>Dieser Druckversuch zählt nicht: %1 Dasselbe Teil noch einmal drücken.</translation>
    </message>
    <message>
        <source>What is measured is stored at once, and shown when the study is finished.</source>
        <translation>Jede Messung ist sofort gespeichert und wird gezeigt, wenn die Studie beendet ist.</translation>
    </message>
    <message>
        <source>Part %1 was taken back and comes again.</source>
        <translation>Teil %1 ist zurückgenommen und kommt noch einmal.</translation>
    </message>
    <message>
        <source>Part %1 was left out.</source>
        <translation>Teil %1 ist ausgelassen.</translation>
    </message>
    <message>
        <source>Part %1 is stored.</source>
        <translation>Teil %1 ist gespeichert.</translation>
    </message>
    <message>
        <source>That is part %1. Take it out and put in part %2.</source>
        <translation>Das ist Teil %1. Herausnehmen und Teil %2 einlegen.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>Leave part %1 out</source>
        <translation>Teil %1 auslassen</translation>
    </message>
    <message>
        <source>Why is it not squeezed? The reason is kept.</source>
        <translation>Warum wird es nicht gedrückt? Der Grund bleibt aufgezeichnet.</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>End the study here</source>
        <translation>Studie hier beenden</translation>
    </message>
    <message>
        <source>Squeezes are left. Why does it end without them? The reason is kept, and the result rests on what was measured.</source>
        <translation>Druckversuche stehen noch aus. Warum endet die Studie ohne sie? Der Grund bleibt aufgezeichnet, und das Ergebnis beruht auf dem, was gemessen wurde.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
</context>
<context>
    <name>gripscope::StudyList</name>
    <message>
        <source>Begun and not finished</source>
        <translation>Begonnen und nicht beendet</translation>
    </message>
    <message>
        <source>Studies, in the order of practice</source>
        <translation>Studien, in der üblichen Reihenfolge</translation>
    </message>
    <message>
        <source>Studies so far</source>
        <translation>Bisherige Studien</translation>
    </message>
    <message>
        <source>No study yet. Begin with a type-1 study if you have a part whose m, b or k is known, else with gauge repeatability and reproducibility: ten parts, three people, three squeezes each.</source>
        <translation>Noch keine Studie. Mit einer Typ-1-Studie beginnen, wenn von einem Teil m, b oder k bekannt ist, sonst mit Wiederhol- und Vergleichpräzision: zehn Teile, drei Personen, je drei Druckversuche.</translation>
    </message>
    <message>
        <source>finished %1 by %2, gripper %3</source>
        <translation>beendet %1 von %2, Greifer %3</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>einer nicht genannten Person</translation>
    </message>
    <message>
        <source>Begin…</source>
        <translation>Beginnen …</translation>
    </message>
    <message>
        <source>Begin: %1</source>
        <translation>Beginnen: %1</translation>
    </message>
    <message>
        <source>Is what is made steady, and within its limits?</source>
        <translation>Ist die Fertigung stetig und innerhalb ihrer Grenzen?</translation>
    </message>
    <message>
        <source>from inspections</source>
        <translation>aus Prüfungen</translation>
    </message>
    <message>
        <source>gripper %1</source>
        <translation>Greifer %1</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Go on with %1</source>
        <translation>%1 fortsetzen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>finished %1 by %2</source>
        <translation>beendet %1 von %2</translation>
    </message>
    <message>
        <source>Open: control charts and capability</source>
        <translation>Öffnen: Regelkarten und Fähigkeit</translation>
    </message>
    <message>
        <source>Control charts and capability</source>
        <translation>Regelkarten und Fähigkeit</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>Look at what moved</source>
        <translation>Ansehen, was sich verschoben hat</translation>
    </message>
    <message>
        <source>What moved</source>
        <translation>Was sich verschoben hat</translation>
    </message>
    <message>
        <source>Sensor, fingers or product: what lies elsewhere than when it was enrolled, and since when?</source>
        <translation>Sensor, Finger oder Produkt: Was liegt anderswo als beim Einlernen, und seit wann?</translation>
    </message>
    <message>
        <source>Another gripper</source>
        <translation>Ein anderer Greifer</translation>
    </message>
    <message>
        <source>with a second gripper</source>
        <translation>mit einem zweiten Greifer</translation>
    </message>
</context>
<context>
    <name>gripscope::StudyOutcome</name>
    <message>
        <source>All studies</source>
        <translation>Alle Studien</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV …</translation>
    </message>
    <message>
        <source>Every measurement that counts, as a table</source>
        <translation>Jede Messung, die zählt, als Tabelle</translation>
    </message>
    <message>
        <source>Report (PDF)…</source>
        <translation>Bericht (PDF) …</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messungen speichern</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>gripper %1</source>
        <translation>Greifer %1</translation>
    </message>
    <message>
        <source>This study was given up.</source>
        <translation>Diese Studie wurde aufgegeben.</translation>
    </message>
    <message>
        <source>Being worked out…</source>
        <translation>Wird ausgewertet …</translation>
    </message>
    <message>
        <source>Distinct categories – %1</source>
        <translation>Unterscheidbare Klassen – %1</translation>
    </message>
    <message>
        <source>Measurements written to %1</source>
        <translation>Messungen nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Bericht nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>gripscope::StudyReport</name>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>Led by</source>
        <translation>Geleitet von</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Von, bis</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>%1 parts, %2 operators, %3 trials, in random order</source>
        <translation>%1 Teile, %2 Bediener, %3 Durchgänge, in zufälliger Reihenfolge</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Squeezed as</source>
        <translation>Gedrückt wie</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>%1 not made, %2 left out, %3 repeated</source>
        <translation>%1 nicht gemacht, %2 ausgelassen, %3 wiederholt</translation>
    </message>
    <message>
        <source>Ended because</source>
        <translation>Beendet, weil</translation>
    </message>
    <message>
        <source>Distinct categories</source>
        <translation>Unterscheidbare Klassen</translation>
    </message>
    <message>
        <source>Made %1 by %2 with Gripscope %3.</source>
        <translation>Erstellt %1 von %2 mit Gripscope %3.</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>einer nicht genannten Person</translation>
    </message>
    <message>
        <source>Study of the gripper: %1</source>
        <translation>Studie des Greifers: %1</translation>
    </message>
    <message>
        <source>Gauge repeatability and reproducibility</source>
        <translation>Wiederhol- und Vergleichpräzision</translation>
    </message>
    <message>
        <source>Type-1 study</source>
        <translation>Typ-1-Studie</translation>
    </message>
    <message>
        <source>Linearity</source>
        <translation>Linearität</translation>
    </message>
    <message>
        <source>Attribute agreement</source>
        <translation>Übereinstimmung von Urteilen</translation>
    </message>
    <message>
        <source>%1 parts, %2 trials, in random order</source>
        <translation>%1 Teile, %2 Durchgänge, in zufälliger Reihenfolge</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Holds until</source>
        <translation>Gilt bis</translation>
    </message>
    <message>
        <source>One part, %1 squeezes</source>
        <translation>Ein Teil, %1 Druckversuche</translation>
    </message>
    <message>
        <source>Types on another gripper</source>
        <translation>Typen an einem anderen Greifer</translation>
    </message>
</context>
<context>
    <name>gripscope::TextQuestion</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>gripscope::TimePlot</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Time (ms)</source>
        <translation>Zeit (ms)</translation>
    </message>
</context>
<context>
    <name>gripscope::TransferLead</name>
    <message>
        <source>Arm the gripper</source>
        <translation>Greifer scharf schalten</translation>
    </message>
    <message>
        <source>Work out the adjustment</source>
        <translation>Anpassung ausrechnen</translation>
    </message>
    <message>
        <source>Take the last one back (Ctrl+Z)</source>
        <translation>Letzten zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Leave this one out…</source>
        <translation>Dieses auslassen …</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Goes back to the list; the squeezes are kept and can be gone on with</source>
        <translation>Geht zur Liste zurück; die Druckversuche bleiben, und es kann fortgesetzt werden</translation>
    </message>
    <message>
        <source>Give up…</source>
        <translation>Aufgeben …</translation>
    </message>
    <message>
        <source>A part of %1</source>
        <translation>Ein Teil von %1</translation>
    </message>
    <message>
        <source>All squeezes are through</source>
        <translation>Alle Druckversuche sind gemacht</translation>
    </message>
    <message>
        <source>Squeeze %1 of %2 of this type</source>
        <translation>Druckversuch %1 von %2 dieses Typs</translation>
    </message>
    <message>
        <source>Any good part of that type will do, another one each time if you have some: what two grippers differ by is held against how parts differ.</source>
        <translation>Jedes gute Teil dieses Typs ist recht, jedes Mal ein anderes, wenn es mehrere gibt: Worin sich zwei Greifer unterscheiden, wird daran gemessen, wie sich Teile unterscheiden.</translation>
    </message>
    <message>
        <source>That squeeze does not count: %1 Squeeze a part of the same type again.</source>
        <translation>Dieser Druckversuch zählt nicht: %1 Noch einmal ein Teil desselben Typs drücken.</translation>
    </message>
    <message>
        <source>Each squeeze is stored at once.</source>
        <translation>Jeder Druckversuch wird sofort gespeichert.</translation>
    </message>
    <message>
        <source>The last squeeze was taken back; a part of its type comes again.</source>
        <translation>Der letzte Druckversuch wurde zurückgenommen; ein Teil seines Typs kommt noch einmal.</translation>
    </message>
    <message>
        <source>The last squeeze is stored.</source>
        <translation>Der letzte Druckversuch ist gespeichert.</translation>
    </message>
    <message>
        <source>Squeezing…</source>
        <translation>Drückt…</translation>
    </message>
    <message>
        <source>Finding m, b and k…</source>
        <translation>m, b und k werden bestimmt…</translation>
    </message>
    <message>
        <source>Being stored…</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Nothing can be taken back once the adjustment is worked out.</source>
        <translation>Ist die Anpassung ausgerechnet, lässt sich nichts mehr zurücknehmen.</translation>
    </message>
    <message>
        <source>Put the part between the fingers, hands clear, then arm.</source>
        <translation>Das Teil zwischen die Finger legen, Hände weg, dann scharf schalten.</translation>
    </message>
    <message>
        <source>Put the part between the fingers, hands clear, then press Space.</source>
        <translation>Das Teil zwischen die Finger legen, Hände weg, dann die Leertaste drücken.</translation>
    </message>
    <message>
        <source>%1 Being worked out…</source>
        <translation>%1 Wird ausgewertet …</translation>
    </message>
    <message>
        <source>Squeeze (Space)</source>
        <translation>Drücken (Leertaste)</translation>
    </message>
    <message>
        <source>From three squeezes of each type on that fit one another; what is missing is said beside</source>
        <translation>Ab drei Druckversuchen je Typ, die zueinander passen; was fehlt, steht daneben</translation>
    </message>
    <message>
        <source>enough for the adjustment</source>
        <translation>genug für die Anpassung</translation>
    </message>
    <message>
        <source>Leave this squeeze of %1 out</source>
        <translation>Diesen Druckversuch von %1 auslassen</translation>
    </message>
    <message>
        <source>Why is it not squeezed? The reason is kept.</source>
        <translation>Warum wird es nicht gedrückt? Der Grund bleibt aufgezeichnet.</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Aufgeben</translation>
    </message>
    <message>
        <source>No adjustment comes of these squeezes then; they stay on record. Why? The reason is kept.</source>
        <translation>Aus diesen Druckversuchen wird dann keine Anpassung; sie bleiben aufgezeichnet. Warum? Der Grund bleibt aufgezeichnet.</translation>
    </message>
</context>
<context>
    <name>gripscope::TransferOutcome</name>
    <message>
        <source>All studies</source>
        <translation>Alle Studien</translation>
    </message>
    <message>
        <source>Accept the adjustment…</source>
        <translation>Anpassung annehmen …</translation>
    </message>
    <message>
        <source>What an adjustment by the other types leaves of each</source>
        <translation>Was eine Anpassung nach den anderen Typen von jedem übrig lässt</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Fits</source>
        <translation>Passt</translation>
    </message>
    <message>
        <source>gripper %1</source>
        <translation>Greifer %1</translation>
    </message>
    <message>
        <source>This was given up: %1</source>
        <translation>Dies wurde aufgegeben: %1</translation>
    </message>
    <message>
        <source>Being worked out…</source>
        <translation>Wird ausgewertet …</translation>
    </message>
    <message>
        <source>The squeezes give no adjustment.</source>
        <translation>Die Druckversuche ergeben keine Anpassung.</translation>
    </message>
    <message>
        <source>%1 does not fit: one adjustment would be wrong for it.</source>
        <translation>%1 passt nicht: Eine gemeinsame Anpassung wäre dafür falsch.</translation>
    </message>
    <message>
        <source>There are fewer than three squeezes of a type.</source>
        <translation>Von einem Typ gibt es weniger als drei Druckversuche.</translation>
    </message>
    <message>
        <source>The squeezes give no adjustment</source>
        <translation>Die Druckversuche ergeben keine Anpassung</translation>
    </message>
    <message>
        <source>One adjustment does not explain all types</source>
        <translation>Eine Anpassung erklärt nicht alle Typen</translation>
    </message>
    <message>
        <source>An adjustment helps: types serve here with it</source>
        <translation>Eine Anpassung hilft: Mit ihr taugen die Typen hier</translation>
    </message>
    <message>
        <source>The two grippers find the same as far as can be told</source>
        <translation>Beide Greifer finden dasselbe, soweit es sich sagen lässt</translation>
    </message>
    <message>
        <source>Residual check: that the types differ so much by chance has a probability of %1. %2</source>
        <translation>Prüfung der Residuen: Dass sich die Typen zufällig so sehr unterscheiden, hat eine Wahrscheinlichkeit von %1. %2</translation>
    </message>
    <message>
        <source>In force since %1, accepted by %2. Every inspection on gripper %3 is adjusted by it.</source>
        <translation>In Kraft seit %1, angenommen von %2. Jede Prüfung am Greifer %3 wird damit angepasst.</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>einer nicht genannten Person</translation>
    </message>
    <message>
        <source>It was accepted %1 and is no longer in force.</source>
        <translation>Sie wurde %1 angenommen und ist nicht mehr in Kraft.</translation>
    </message>
    <message>
        <source>Another adjustment of this gripper is in force since %1: this one would replace it.</source>
        <translation>Eine andere Anpassung dieses Greifers ist seit %1 in Kraft: Diese würde sie ersetzen.</translation>
    </message>
    <message>
        <source>no other type</source>
        <translation>kein anderer Typ</translation>
    </message>
    <message>
        <source>yes (%1)</source>
        <translation>ja (%1)</translation>
    </message>
    <message>
        <source>no (%1)</source>
        <translation>nein (%1)</translation>
    </message>
    <message>
        <source>The adjustment</source>
        <translation>Die Anpassung</translation>
    </message>
    <message>
        <source>Adjust gripper %1</source>
        <translation>Greifer %1 anpassen</translation>
    </message>
    <message>
        <source>Gripper %1 is adjusted to the types from now on.</source>
        <translation>Greifer %1 wird von jetzt an den Typen angepasst.</translation>
    </message>
</context>
<context>
    <name>gripscope::TransferStart</name>
    <message>
        <source>a gripper not named</source>
        <translation>einem nicht genannten Greifer</translation>
    </message>
    <message>
        <source>Adjustments</source>
        <translation>Anpassungen</translation>
    </message>
    <message>
        <source>All studies</source>
        <translation>Alle Studien</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Types on another gripper</source>
        <translation>Typen an einem anderen Greifer</translation>
    </message>
    <message>
        <source>Types were enrolled on one gripper and are to be recognised by another. Squeeze parts of some of them here: how the two grippers differ follows from that, and every later inspection on this gripper is adjusted by it.</source>
        <translation>Typen wurden an einem Greifer eingelernt und sollen von einem anderen erkannt werden. Teile einiger davon hier drücken: Daraus folgt, worin sich die beiden Greifer unterscheiden, und jede spätere Prüfung an diesem Greifer wird damit angepasst.</translation>
    </message>
    <message>
        <source>Squeezes of each type</source>
        <translation>Druckversuche je Typ</translation>
    </message>
    <message>
        <source>Which types do you have parts of here?</source>
        <translation>Von welchen Typen sind hier Teile da?</translation>
    </message>
    <message>
        <source>Connected is gripper %1. No type was enrolled on another.</source>
        <translation>Verbunden ist Greifer %1. Kein Typ wurde an einem anderen eingelernt.</translation>
    </message>
    <message>
        <source>Connected is gripper %1. Types were enrolled on: %2.</source>
        <translation>Verbunden ist Greifer %1. Typen wurden eingelernt an: %2.</translation>
    </message>
    <message>
        <source>enrolled on this gripper itself</source>
        <translation>an diesem Greifer selbst eingelernt</translation>
    </message>
    <message>
        <source>not approved</source>
        <translation>nicht freigegeben</translation>
    </message>
    <message>
        <source>enrolled on %1</source>
        <translation>eingelernt an %1</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>somebody not named</source>
        <translation>einer nicht genannten Person</translation>
    </message>
    <message>
        <source>Gripper %1: in force</source>
        <translation>Greifer %1: in Kraft</translation>
    </message>
    <message>
        <source>Gripper %1: withdrawn</source>
        <translation>Greifer %1: zurückgezogen</translation>
    </message>
    <message>
        <source>Gripper %1: replaced</source>
        <translation>Greifer %1: ersetzt</translation>
    </message>
    <message>
        <source>%1. Accepted %2 by %3, of %4 squeezes of %5: %6</source>
        <translation>%1. Angenommen %2 von %3, aus %4 Druckversuchen von %5: %6</translation>
    </message>
    <message>
        <source>Withdrawn %1 by %2: %3</source>
        <translation>Zurückgezogen %1 von %2: %3</translation>
    </message>
    <message>
        <source>Withdraw…</source>
        <translation>Zurückziehen …</translation>
    </message>
    <message>
        <source>Withdraw the adjustment of gripper %1</source>
        <translation>Anpassung des Greifers %1 zurückziehen</translation>
    </message>
    <message>
        <source>The adjustment is withdrawn.</source>
        <translation>Die Anpassung ist zurückgezogen.</translation>
    </message>
    <message>
        <source>Another gripper %1</source>
        <translation>Ein anderer Greifer %1</translation>
    </message>
    <message>
        <source>Connect the gripper that the types are to be recognised by.</source>
        <translation>Den Greifer verbinden, der die Typen erkennen soll.</translation>
    </message>
    <message>
        <source>This gripper has no serial number to keep an adjustment under.</source>
        <translation>Dieser Greifer hat keine Seriennummer, unter der eine Anpassung aufbewahrt werden könnte.</translation>
    </message>
    <message>
        <source>No type is enrolled. Enrol types on the other gripper, in this library, first.</source>
        <translation>Kein Typ ist eingelernt. Zuerst am anderen Greifer Typen einlernen, in dieser Bibliothek.</translation>
    </message>
    <message>
        <source>Choose the types that you have parts of, two or more.</source>
        <translation>Die Typen wählen, von denen Teile da sind, zwei oder mehr.</translation>
    </message>
    <message>
        <source>%1 squeezes, in random order.</source>
        <translation>%1 Druckversuche, in zufälliger Reihenfolge.</translation>
    </message>
    <message>
        <source>%1 With a second type it shows whether one adjustment serves all.</source>
        <translation>%1 Mit einem zweiten Typ zeigt sich, ob eine Anpassung für alle taugt.</translation>
    </message>
</context>
<context>
    <name>gripscope::TrendPlot</name>
    <message>
        <source>Mass m</source>
        <translation>Masse m</translation>
    </message>
    <message>
        <source>Damping b</source>
        <translation>Dämpfung b</translation>
    </message>
    <message>
        <source>Stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>of no type</source>
        <translation>ohne Typ</translation>
    </message>
    <message>
        <source>suspect</source>
        <translation>fraglich</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>Time (UTC)</source>
        <translation>Zeit (UTC)</translation>
    </message>
    <message>
        <source>%1, standard error</source>
        <translation>%1, Standardfehler</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Dotted lines: where the gate of the type ends at the rates set now; a squeeze beyond one of them is called unknown.</source>
        <translation>Gepunktete Linien: wo die Grenze des Typs bei den jetzt eingestellten Fehlerraten endet; ein Druckversuch jenseits einer davon heißt unbekannt.</translation>
    </message>
</context>
<context>
    <name>gripscope::TrendView</name>
    <message>
        <source>Mass, damping and stiffness of the squeezes</source>
        <translation>Masse, Dämpfung und Steifigkeit der Druckversuche</translation>
    </message>
    <message>
        <source>Mass, damping and stiffness</source>
        <translation>Masse, Dämpfung und Steifigkeit</translation>
    </message>
</context>
<context>
    <name>gripscope::TrialDialog</name>
    <message>
        <source>Trial: it would be %1 (posterior %2).</source>
        <translation>Probe: Es wäre %1 (Wahrsch. %2).</translation>
    </message>
    <message>
        <source>Trial: it would be unknown.</source>
        <translation>Probe: Es wäre unbekannt.</translation>
    </message>
    <message>
        <source>Trial: it would be inconclusive.</source>
        <translation>Probe: Es wäre unentschieden.</translation>
    </message>
    <message>
        <source>Trial: it would not be judged.</source>
        <translation>Probe: Es würde nicht beurteilt.</translation>
    </message>
    <message>
        <source>Try %1</source>
        <translation>%1 ausprobieren</translation>
    </message>
    <message>
        <source>What would a part be called?</source>
        <translation>Wie würde ein Teil benannt?</translation>
    </message>
    <message>
        <source>The part is held against the approved types and %1, at the rates that are set. This is a trial: nothing is stored, counted or approved.</source>
        <translation>Das Teil wird mit den freigegebenen Typen und %1 verglichen, bei den eingestellten Fehlerraten. Das ist eine Probe: Nichts wird gespeichert, gezählt oder freigegeben.</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Squeeze again</source>
        <translation>Erneut drücken</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>gripscope::TypeChangeForm</name>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Why? The reason is kept with the change.</source>
        <translation>Warum? Der Grund wird mit der Änderung aufbewahrt.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1:  k %2   b %3   m %4</source>
        <translation>%1:  k %2   b %3   m %4</translation>
    </message>
    <message>
        <source>   part %1</source>
        <translation>   Teil %1</translation>
    </message>
</context>
<context>
    <name>gripscope::TypeChooser</name>
    <message>
        <source>Expected type</source>
        <translation>Erwarteter Typ</translation>
    </message>
    <message>
        <source>Choose a type, type part of its name, or scan its code anywhere on this page</source>
        <translation>Einen Typ wählen, einen Teil seines Namens tippen oder seinen Code irgendwo auf dieser Seite scannen</translation>
    </message>
    <message>
        <source>nothing expected</source>
        <translation>nichts erwartet</translation>
    </message>
</context>
<context>
    <name>gripscope::TypeLimitsDialog</name>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>%1: too few squeezes whose uncertainty is known</source>
        <translation>%1: zu wenige Druckversuche mit bekannter Unsicherheit</translation>
    </message>
    <message>
        <source>%1, by %2 squeezes: consumer&apos;s risk %3, producer&apos;s risk %4</source>
        <translation>%1, nach %2 Druckversuchen: Kundenrisiko %3, Herstellerrisiko %4</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Tolerance limits</source>
        <translation>Toleranzgrenzen</translation>
    </message>
    <message>
        <source>Parts that are recognised as this type are then also said to conform, not to conform, or to be too near the limit for their squeeze.</source>
        <translation>Von Teilen, die als dieser Typ erkannt werden, heißt es dann auch, ob sie konform sind, nicht konform oder für ihren Druckversuch zu nahe an der Grenze.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Rule of decision</source>
        <translation>Entscheidungsregel</translation>
    </message>
    <message>
        <source>Proven with 95 % (ISO 14253-1)</source>
        <translation>Mit 95 % nachgewiesen (ISO 14253-1)</translation>
    </message>
    <message>
        <source>Proven up to a consumer&apos;s risk of</source>
        <translation>Nachgewiesen bis zu einem Kundenrisiko von</translation>
    </message>
    <message>
        <source>By the value alone</source>
        <translation>Nach dem Wert allein</translation>
    </message>
    <message>
        <source>Consumer&apos;s risk</source>
        <translation>Kundenrisiko</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Why? The reason is kept with the change.</source>
        <translation>Warum? Der Grund wird mit der Änderung aufbewahrt.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>A limit is not a number.</source>
        <translation>Eine Grenze ist keine Zahl.</translation>
    </message>
    <message>
        <source>Without a limit nothing is said of parts beyond their type.</source>
        <translation>Ohne Grenze wird über Teile nichts außer ihrem Typ gesagt.</translation>
    </message>
    <message>
        <source>Consumer&apos;s risk: of all parts, those accepted that do not conform. Producer&apos;s risk: those that conform and are not accepted, too near a limit among them (JCGM 106).</source>
        <translation>Kundenrisiko: von allen Teilen die, die angenommen werden, obwohl sie nicht konform sind. Herstellerrisiko: die, die konform sind und nicht angenommen werden, auch weil sie zu nahe an einer Grenze liegen (JCGM 106).</translation>
    </message>
</context>
<context>
    <name>gripscope::TypeMap</name>
    <message>
        <source>Stiffness and damping of the types and of this part</source>
        <translation>Steifigkeit und Dämpfung der Typen und dieses Teils</translation>
    </message>
    <message>
        <source>No types yet. Enroll one to see where it lies.</source>
        <translation>Noch keine Typen. Einen einlernen, um seine Lage zu sehen.</translation>
    </message>
    <message>
        <source>stiffness (%1)</source>
        <translation>Steifigkeit (%1)</translation>
    </message>
    <message>
        <source>this part</source>
        <translation>dieses Teil</translation>
    </message>
    <message>
        <source>b (%1)</source>
        <translation>b (%1)</translation>
    </message>
    <message>
        <source>damping (%1)</source>
        <translation>Dämpfung (%1)</translation>
    </message>
    <message>
        <source>Map of the types</source>
        <translation>Karte der Typen</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>edge of 95 %</source>
        <translation>Rand der 95 %</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>Druckversuch</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>No map: these types are told apart without m, b and k.</source>
        <translation>Keine Karte: Diese Typen werden ohne m, b und k unterschieden.</translation>
    </message>
    <message>
        <source>k (%1)</source>
        <translation>k (%1)</translation>
    </message>
</context>
<context>
    <name>gripscope::TypeScene</name>
    <message>
        <source>Mass m</source>
        <translation>Masse m</translation>
    </message>
    <message>
        <source>Damping b</source>
        <translation>Dämpfung b</translation>
    </message>
    <message>
        <source>Stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>%1, squeeze %2</source>
        <translation>%1, Druckversuch %2</translation>
    </message>
</context>
<context>
    <name>gripscope::TypesPage</name>
    <message>
        <source>Colour: cluster. Shape: type.</source>
        <translation>Farbe: Cluster. Form: Typ.</translation>
    </message>
    <message>
        <source>The plus signs are the centroids.</source>
        <translation>Die Pluszeichen sind die Zentren.</translation>
    </message>
    <message>
        <source>The plus signs are the means, the ellipsoids hold 95 % of each component.</source>
        <translation>Die Pluszeichen sind die Mittelwerte, die Ellipsoide enthalten 95 % jeder Komponente.</translation>
    </message>
    <message>
        <source>The net is the map: a dot a unit, a line between neighbours.</source>
        <translation>Das Netz ist die Karte: ein Punkt je Einheit, eine Linie zwischen Nachbarn.</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>No types in this library yet</source>
        <translation>Noch keine Typen in dieser Bibliothek</translation>
    </message>
    <message>
        <source>Ringed: inspection %1</source>
        <translation>Mit Ring: Prüfung %1</translation>
    </message>
    <message>
        <source>Ringed: the latest inspection</source>
        <translation>Mit Ring: die letzte Prüfung</translation>
    </message>
    <message>
        <source>No type here has m, b and k</source>
        <translation>Kein Typ hier hat m, b und k</translation>
    </message>
    <message>
        <source>Recognised without a mass, by what their squeezes tell, and not in this picture: %1.</source>
        <translation>Ohne Masse erkannt, an dem, was ihre Druckversuche verraten, und nicht in diesem Bild: %1.</translation>
    </message>
    <message>
        <source>Enrol a type on the Enroll page: about ten squeezes of good parts. Or load the four cans of the paper as examples, or simulated parts that go on yielding.</source>
        <translation>Auf der Seite Einlernen einen Typ einlernen: etwa zehn Druckversuche an guten Teilen. Oder die vier Dosen der Veröffentlichung als Beispiele laden, oder simulierte Teile, die weiter nachgeben.</translation>
    </message>
</context>
<context>
    <name>gripscope::TypesSide</name>
    <message>
        <source>Open in Fit</source>
        <translation>Im Fit öffnen</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>squeezes</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Picked squeeze</source>
        <translation>Gewählter Druckversuch</translation>
    </message>
    <message>
        <source>Nearest pair</source>
        <translation>Nächstes Paar</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>%1 zeigen oder verbergen</translation>
    </message>
    <message>
        <source>With one squeeze a type nothing is known of how squeezes scatter, so there is no ellipsoid yet. Enrol more: ten a type is good.</source>
        <translation>Mit einem Druckversuch je Typ ist über die Streuung nichts bekannt, daher gibt es noch kein Ellipsoid. Weitere einlernen: zehn je Typ sind gut.</translation>
    </message>
    <message>
        <source>%1 and %2 are %3 sd apart.</source>
        <translation>%1 und %2 liegen %3 σ auseinander.</translation>
    </message>
    <message>
        <source>Two types with some squeezes each are needed.</source>
        <translation>Zwei Typen mit je einigen Druckversuchen sind nötig.</translation>
    </message>
    <message>
        <source>Mahalanobis distance of the two means, in standard deviations of the scatter that all types share. Below about 4 they overlap.</source>
        <translation>Mahalanobis-Abstand der beiden Mittelwerte, in Standardabweichungen der gemeinsamen Streuung aller Typen. Unter etwa 4 überlappen sie.</translation>
    </message>
    <message>
        <source>Click a point, or press N for the next one.</source>
        <translation>Einen Punkt anklicken oder N für den nächsten drücken.</translation>
    </message>
    <message>
        <source>Manage types…</source>
        <translation>Verwalten…</translation>
    </message>
    <message>
        <source>Rename, merge, split or retire types; undo changes</source>
        <translation>Typen umbenennen, zusammenführen, aufteilen oder außer Gebrauch nehmen; Änderungen rückgängig machen</translation>
    </message>
    <message>
        <source>Without m, b and k, so not in this picture: %1.</source>
        <translation>Ohne m, b und k, darum nicht in diesem Bild: %1.</translation>
    </message>
    <message>
        <source>Limits…</source>
        <translation>Toleranzen…</translation>
    </message>
    <message>
        <source>What mass, damping and stiffness of the parts of a type may be</source>
        <translation>Was Masse, Dämpfung und Steifigkeit der Teile eines Typs sein dürfen</translation>
    </message>
</context>
<context>
    <name>gripscope::UncertaintyPanel</name>
    <message>
        <source>Natural frequency</source>
        <translation>Eigenfrequenz</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>What would make it better</source>
        <translation>Was es besser machen würde</translation>
    </message>
    <message>
        <source>What the error bars are made of</source>
        <translation>Woraus die Fehlerbalken bestehen</translation>
    </message>
    <message>
        <source>What follows from m, b and k (95 %)</source>
        <translation>Was aus m, b und k folgt (95 %)</translation>
    </message>
    <message>
        <source>The measurement is not valid. The failed checks say what to do first.</source>
        <translation>Die Messung ist ungültig. Die nicht bestandenen Prüfpunkte sagen, was zuerst zu tun ist.</translation>
    </message>
    <message>
        <source>Without error bars there is nothing to improve on. Squeeze again.</source>
        <translation>Ohne Fehlerbalken gibt es nichts zu verbessern. Erneut drücken.</translation>
    </message>
</context>
<context>
    <name>gripscope::ValidationChooser</name>
    <message>
        <source>Squeeze %1, %2</source>
        <translation>Druckversuch %1, %2</translation>
    </message>
    <message>
        <source>%1, squeeze %2</source>
        <translation>%1, Druckversuch %2</translation>
    </message>
    <message>
        <source>A recording (CSV)…</source>
        <translation>Eine Aufnahme (CSV)…</translation>
    </message>
    <message>
        <source>Stored squeezes</source>
        <translation>Gespeicherte Druckversuche</translation>
    </message>
    <message>
        <source>Validate with a recording</source>
        <translation>Mit einer Aufnahme validieren</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Aufnahmen (*.csv *.tsv *.txt);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>gripscope::ValidationPanel</name>
    <message>
        <source>On data it was not found from</source>
        <translation>An Daten, aus denen sie nicht stammt</translation>
    </message>
    <message>
        <source>Validate with</source>
        <translation>Validieren mit</translation>
    </message>
    <message>
        <source>Hold this estimate against another squeeze: its start and offset are fitted anew, m, b and k are not</source>
        <translation>Diese Schätzung an einem anderen Druckversuch prüfen: Anfang und Nullpunkt werden neu angepasst, m, b und k nicht</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Validation</source>
        <translation>Validierung</translation>
    </message>
    <message>
        <source>This estimate was not held against other data yet.</source>
        <translation>Diese Schätzung wurde noch nicht an anderen Daten geprüft.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Measured position</source>
        <translation>Gemessener Weg</translation>
    </message>
    <message>
        <source>model from elsewhere</source>
        <translation>Modell von anderswo</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
</context>
<context>
    <name>gripscope::ValidationWords</name>
    <message>
        <source>%1, %2 samples</source>
        <translation>%1, %2 Abtastwerte</translation>
    </message>
    <message>
        <source>the last %1 samples, found from the first %2</source>
        <translation>die letzten %1 Abtastwerte, bestimmt aus den ersten %2</translation>
    </message>
    <message>
        <source>Held against</source>
        <translation>Geprüft an</translation>
    </message>
    <message>
        <source>%1, expected %2</source>
        <translation>%1, erwartet %2</translation>
    </message>
    <message>
        <source>Simulation fit</source>
        <translation>Simulationsfit</translation>
    </message>
    <message>
        <source>Prediction fit</source>
        <translation>Vorhersagefit</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>white</source>
        <translation>weiß</translation>
    </message>
    <message>
        <source>not white</source>
        <translation>nicht weiß</translation>
    </message>
    <message>
        <source>Against force</source>
        <translation>Gegen Kraft</translation>
    </message>
    <message>
        <source>independent</source>
        <translation>unabhängig</translation>
    </message>
    <message>
        <source>dependent</source>
        <translation>abhängig</translation>
    </message>
    <message>
        <source>m, b and k</source>
        <translation>m, b und k</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>gelten</translation>
    </message>
    <message>
        <source>do not hold</source>
        <translation>gelten nicht</translation>
    </message>
    <message>
        <source>Change of m</source>
        <translation>Änderung von m</translation>
    </message>
    <message>
        <source>Change of b</source>
        <translation>Änderung von b</translation>
    </message>
    <message>
        <source>Change of k</source>
        <translation>Änderung von k</translation>
    </message>
    <message>
        <source>the force answers to disturbances of the position, which periodic allows for and output error does not</source>
        <translation>die Kraft reagiert auf Störungen des Wegs, was periodic berücksichtigt und das Ausgangsfehlermodell nicht</translation>
    </message>
    <message>
        <source>the force does not answer to the position</source>
        <translation>die Kraft hängt nicht vom Weg ab</translation>
    </message>
    <message>
        <source>harmonics that the force does not have show a spring or damper that is not linear</source>
        <translation>Oberschwingungen, die die Kraft nicht hat, zeigen eine nichtlineare Feder oder Dämpfung</translation>
    </message>
    <message>
        <source>no harmonic shows more than a linear object</source>
        <translation>keine Oberschwingung zeigt mehr als ein lineares Objekt</translation>
    </message>
    <message>
        <source>the misfit is larger than what changes from period to period explains, and the errors were enlarged to match</source>
        <translation>der Modellfehler ist größer, als die Unterschiede zwischen den Perioden erklären, die Fehler wurden entsprechend vergrößert</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Perioden</translation>
    </message>
    <message>
        <source>%1 of %2 samples</source>
        <translation>%1 von %2 Abtastwerten</translation>
    </message>
    <message>
        <source>Force noise</source>
        <translation>Rauschen der Kraft</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>Rauschen des Wegs</translation>
    </message>
    <message>
        <source>Their correlation</source>
        <translation>Ihre Korrelation</translation>
    </message>
    <message>
        <source>Drift of force</source>
        <translation>Drift der Kraft</translation>
    </message>
    <message>
        <source>Drift of position</source>
        <translation>Drift des Wegs</translation>
    </message>
    <message>
        <source>Misfit over noise</source>
        <translation>Modellfehler zu Rauschen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Verzerrung</translation>
    </message>
    <message>
        <source>not told: the force leaves no harmonic empty</source>
        <translation>nicht zu sagen: Die Kraft lässt keine Oberschwingung frei</translation>
    </message>
</context>
<context>
    <name>gripscope::ValidityLine</name>
    <message>
        <source>Measurement valid</source>
        <translation>Messung gültig</translation>
    </message>
    <message>
        <source>Measurement suspect</source>
        <translation>Messung fraglich</translation>
    </message>
    <message>
        <source>Measurement not valid</source>
        <translation>Messung ungültig</translation>
    </message>
</context>
<context>
    <name>gripscope::VoidDialog</name>
    <message>
        <source>Void it</source>
        <translation>Stornieren</translation>
    </message>
    <message>
        <source>Void inspection %1</source>
        <translation>Prüfung %1 stornieren</translation>
    </message>
    <message>
        <source>It stays on record with the reason, and counts neither in the yield nor in the batch. This cannot be undone.</source>
        <translation>Sie bleibt mit dem Grund gespeichert und zählt weder zur Ausbeute noch zum Los. Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Squeezed twice</source>
        <translation>Zweimal gedrückt</translation>
    </message>
    <message>
        <source>Nothing in the jaws</source>
        <translation>Nichts in den Backen</translation>
    </message>
    <message>
        <source>or why else</source>
        <translation>oder ein anderer Grund</translation>
    </message>
    <message>
        <source>Why it does not count</source>
        <translation>Warum sie nicht zählt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>gripscope::WindowHost</name>
    <message>
        <source>STOP is not an emergency stop: it asks the gripper&apos;s own electronics, over USB. For the safety of people fit a switch that takes the power from the gripper&apos;s drive.</source>
        <translation>STOPP ist kein Not-Halt: Er bittet die Elektronik des Greifers, über USB. Für die Sicherheit von Menschen gehört ein Schalter dazu, der dem Antrieb des Greifers die Energie nimmt.</translation>
    </message>
    <message>
        <source>The screen changes as soon as what is under way on the Calibrate page is accepted or left: it would be lost.</source>
        <translation>Die Anzeige wechselt, sobald übernommen oder verlassen ist, was auf der Seite Kalibrieren läuft: Es ginge sonst verloren.</translation>
    </message>
</context>
<context>
    <name>gripscope::Workbench</name>
    <message>
        <source>operator not named</source>
        <translation>Bediener nicht genannt</translation>
    </message>
    <message>
        <source>The raw reports of this session are not being kept: %1 Measuring goes on.</source>
        <translation>Die Rohdaten dieser Sitzung werden nicht aufbewahrt: %1 Das Messen geht weiter.</translation>
    </message>
    <message numerus="yes">
        <source>The disk is too slow: of the raw reports of this session %n are not kept. Measuring goes on.</source>
        <translation>
            <numerusform>Der Datenträger ist zu langsam: %n Report dieser Sitzung wird nicht aufbewahrt. Das Messen geht weiter.</numerusform>
            <numerusform>Der Datenträger ist zu langsam: %n Reports dieser Sitzung werden nicht aufbewahrt. Das Messen geht weiter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Check on the reference spring: %1 Make it on the Calibrate page.</source>
        <translation>Kontrolle an der Referenzfeder: %1 Auf der Seite Kalibrieren machen.</translation>
    </message>
    <message>
        <source>Another squeeze is under way. Wait for its end, then try again.</source>
        <translation>Ein anderer Druckversuch läuft. Das Ende abwarten, dann erneut versuchen.</translation>
    </message>
</context>
<context>
    <name>gripscope::YieldStrip</name>
    <message>
        <source>%1 as expected</source>
        <translation>%1 wie erwartet</translation>
    </message>
    <message>
        <source>%1 of a known type</source>
        <translation>%1 eines bekannten Typs</translation>
    </message>
    <message>
        <source>Last %1 inspections</source>
        <translation>Die letzten %1 Prüfungen</translation>
    </message>
</context>
</TS>
