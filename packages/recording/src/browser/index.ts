export { BlobSource } from './blob-source.ts';
export { RangeSource } from './range-source.ts';
