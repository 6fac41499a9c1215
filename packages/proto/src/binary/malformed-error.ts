/** Bytes break the structure they claim to have. Leaves the package as the cause of a `DecodeError`. */
export class MalformedError extends Error {
  override readonly name = 'MalformedError';
}
