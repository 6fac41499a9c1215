export * from './tensorflow/choose-backend.ts';
export * from './tensorflow/create-tensorflow.ts';
export type { Files } from './tensorflow/memory-platform.ts';
