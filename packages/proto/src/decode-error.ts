/** Thrown when bytes or JSON are not what they claim to be. */
export class DecodeError extends Error {
  override readonly name = 'DecodeError';
  /** Expected message, by its full name. */
  readonly messageType: string;
  /** Size of the input in bytes; 0 for JSON. */
  readonly byteLength: number;

  /**
   * @param messageType full name of the message that was expected
   * @param byteLength size of the input in bytes, 0 for JSON
   * @param reason what was found instead; ends up in the message
   */
  constructor(messageType: string, byteLength: number, reason: string, cause?: unknown) {
    const input = byteLength === 0 ? 'input' : `${byteLength} bytes`;
    super(`${input} cannot be read as ${messageType}: ${reason}`, { cause });
    this.messageType = messageType;
    this.byteLength = byteLength;
  }

  /** Wraps what a reader threw. */
  static wrap(messageType: string, byteLength: number, cause: unknown): DecodeError {
    if (cause instanceof DecodeError) return cause;
    const reason = cause instanceof Error ? cause.message : String(cause);
    return new DecodeError(messageType, byteLength, reason, cause);
  }
}
