-- What version 3 of the schema added to library_version_2.sql.
-- Do not edit: it stands for the files that users have.
INSERT INTO schema_migrations VALUES (3, 'the noise of a gripper''s force channel', 'd9dce13d44c1015bbeb24bd09c2ec4b7f0c9c6c9b0f49fdecc871916c1716a84', '0.2.0', 'plant-1', '2024-07-31T12:00:00.000Z');
ALTER TABLE measuring_chains ADD COLUMN force_noise_deviation DOUBLE PRECISION NOT NULL DEFAULT 0;
