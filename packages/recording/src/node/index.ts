export { DiskFile } from './disk-file.ts';
export {
  keepToOwner,
  OWNER_FILE_MODE,
  OWNER_FOLDER_MODE,
  DiskFolder,
  recordingPath,
  recordingsFolder,
  uploadPath,
} from './disk-folder.ts';
