// Possible values of module inputs, independent of OpenCV and TensorFlow.js, for the code and for user interfaces.
import { MARKER_DICTIONARIES } from './markers/dictionaries.ts';

export { DETECTOR_NAMES } from './detection/detector-names.ts';
export { PIXEL_FORMATS } from './picture.ts';
export { BACKEND_CHOICES } from './tensorflow/backend-names.ts';

/** Names of the families of markers. */
export const DICTIONARY_NAMES: readonly string[] = MARKER_DICTIONARIES.map(({ name }) => name);
