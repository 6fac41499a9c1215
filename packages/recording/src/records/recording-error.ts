/** A file cannot be read as a recording. */
export class RecordingError extends Error {
  override readonly name = 'RecordingError';
}

/** A file is larger in a part than readers take. What is read of it until there is no whole recording. [RC-43] */
export class RecordingLimitError extends RecordingError {}
