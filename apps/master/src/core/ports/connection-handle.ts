/**
 * The master's side of one live pipe: the adapter of the transport calls it. No method throws. After
 * `handleClose`, or once another pipe of the client took over, calls are ignored.
 */
export interface ConnectionHandle {
  /** Input has arrived: messages follow, in the same turn, until `handleReadEnd`. An adapter that cannot tell leaves both out. */
  handleReadStart(): void;
  /** All messages of the input that has arrived were handed over. */
  handleReadEnd(): void;
  /** A binary message. Takes over `bytes` and their buffer: the caller must not modify them any more. */
  handleBinary(bytes: Uint8Array): void;
  /** A text message. */
  handleText(text: string): void;
  /** The system took all that was handed over: `queuedBytes` is small again. Due after it grew beyond `limits.connectionQueuedBytes`. */
  handleDrain(): void;
  /** The adapter refused input on its own, such as a frame over the size limit. `reason` is one sentence. Counted as a protocol error. */
  handleProtocolError(reason: string): void;
  /** The pipe is closed. @param code WebSocket close code of the other side, where it said one */
  handleClose(code?: number): void;
}
