export { MemoryFile } from './memory-file.ts';
