import { BACKEND_CHOICES } from '@ubii/vision/choices';

// Inputs and outputs that modules for images share.

export const IMAGE_INPUT = {
  format: 'image2D',
  description: 'Raw pixels, or a JPEG or PNG file, up to 16 megapixels.',
} as const;

export const BACKEND_INPUT = {
  format: 'string',
  default: 'auto',
  description: 'Backend; auto chooses the fastest.',
  choices: BACKEND_CHOICES,
} as const;

/** The rate of detections, with another default for each module. */
export const MAX_RATE_INPUT = {
  format: 'double',
  description: 'Most detections per second, 0.1 to 240; images in between are dropped.',
} as const;

/** The times of one image. */
export const TIME_OUTPUTS = {
  decodeMs: { format: 'double', description: 'Decoding time of the image, ms.' },
  durationMs: { format: 'double', description: 'Decoding and computing time, ms.' },
} as const;

/** The backend in use, and the failed ones. */
export const BACKEND_OUTPUTS = {
  backend: {
    format: 'string',
    description: 'The backend in use: webgpu, webgl, wasm or cpu.',
  },
  backendFault: {
    format: 'string',
    description: 'Failed backends, reasons and replacements; empty when none failed.',
  },
} as const;
