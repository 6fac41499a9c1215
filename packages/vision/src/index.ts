export * from './tensorflow/backend-names.ts';
export * from './tensorflow/choose-backend.ts';
export * from './tensorflow/create-tensorflow.ts';
export type { Files } from './tensorflow/memory-platform.ts';
export * from './image-tools/convert-picture.ts';
export { cropPicture, scalePicture, type Rectangle } from './image-tools/crop-and-scale.ts';
export * from './image-tools/measure-picture.ts';
export { ModelChoice } from './model-choice.ts';
export type { ModelSource, ModelSources } from './model-sources.ts';
export * from './picture.ts';
export * from './detection/boxes.ts';
export { CENTER_NET_MODEL, createCenterNet } from './detection/center-net.ts';
export * from './detection/coco-classes.ts';
export * from './detection/coco-ssd.ts';
export type * from './detection/detector.ts';
export * from './detection/detector-choice.ts';
export * from './detection/detector-names.ts';
export * from './pose/body-keypoints.ts';
export * from './pose/body-pose.ts';
export * from './pose/hand-keypoints.ts';
export * from './pose/hand-pose.ts';
export { decodePicture, readImage2D } from './decoding/decode-picture.ts';
export * from './messages/detection-messages.ts';
export {
  OPENCV_WASM_FILE,
  OpenCvError,
  sharedOpenCv,
  type OpenCvRuntime,
} from './opencv/open-cv-runtime.ts';
export type { OpenCvFactory } from './opencv/open-cv.ts';
export * from './markers/camera-calibration.ts';
export * from './markers/camera-calibrator.ts';
export { WANTED_VIEWS } from './markers/calibration-views.ts';
export * from './markers/charuco-board.ts';
export * from './markers/dictionaries.ts';
export * from './markers/marker-tracker.ts';
export type { MarkerPose, PixelPoint } from './markers/marker-pose.ts';
