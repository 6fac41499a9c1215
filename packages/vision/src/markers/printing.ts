// What pages need to draw markers and boards, without OpenCV and TensorFlow.js.
export * from './charuco-board.ts';
export * from './dictionaries.ts';
export * from './marker-cells.ts';
