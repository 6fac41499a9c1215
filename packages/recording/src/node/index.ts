export { DiskFile } from './disk-file.ts';
export { DiskFolder, recordingPath, recordingsFolder, uploadPath } from './disk-folder.ts';
