// Exports for pages with markers and cameras, without OpenCV and TensorFlow.js.
export * from './camera-calibration.ts';
export { WANTED_VIEWS } from './calibration-views.ts';
export * from './charuco-board.ts';
export * from './dictionaries.ts';
