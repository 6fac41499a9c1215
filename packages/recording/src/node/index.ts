export { DiskFile } from './disk-file.ts';
