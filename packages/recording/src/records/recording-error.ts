/** A file cannot be read as a recording. */
export class RecordingError extends Error {
  override readonly name = 'RecordingError';
}
