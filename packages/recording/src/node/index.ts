export { DiskFile } from './disk-file.ts';
export { keepToOwner, OWNER_FILE_MODE, OWNER_FOLDER_MODE } from './owner-modes.ts';
export { DiskFolder, recordingPath, recordingsFolder, uploadPath } from './disk-folder.ts';
