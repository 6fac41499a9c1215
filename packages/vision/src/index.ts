export * from './tensorflow/choose-backend.ts';
export * from './tensorflow/create-tensorflow.ts';
export type { Files } from './tensorflow/memory-platform.ts';
export * from './image-tools/convert-picture.ts';
export * from './image-tools/crop-picture.ts';
export * from './image-tools/histogram.ts';
export * from './image-tools/motion-energy.ts';
export * from './image-tools/scale-picture.ts';
export * from './picture.ts';
