export { BlobSource, RangeSource } from './sources.ts';
