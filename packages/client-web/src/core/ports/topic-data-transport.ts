/** Handlers of the core for the events of a socket, called in this order: open, frames, close. */
export interface TopicDataHandler {
  /** The socket can send. Not called for a socket that could not be opened. */
  handleOpen(): void;
  /** A binary frame. The bytes are the callee's to keep. */
  handleBinary(bytes: Uint8Array): void;
  /** A text frame. */
  handleText(text: string): void;
  /**
   * The socket is gone, or could not be opened. Called exactly once and last, also after `close()`.
   * @param code WebSocket close code; 1006 when the link broke or never came up.
   */
  handleClose(code: number, reason: string): void;
}

/** One socket of the topic-data channel, possibly not open yet. */
export interface TopicDataSocket {
  /** Sends one binary frame; does nothing unless open. The bytes may be reused after the call. */
  sendBinary(borrowedBytes: Uint8Array): void;
  /** Sends one text frame; does nothing unless open. */
  sendText(text: string): void;
  /** Bytes handed over and not yet taken by the system. */
  readonly bufferedBytes: number;
  /** Closes the socket; idempotent. `handleClose` follows. */
  close(code?: number, reason?: string): void;
}

/** Client of a socket, for the query of its URL. */
export interface TopicDataQuery {
  readonly clientId: string;
  /** The resume token, on masters of ours. [EX-4] */
  readonly resumeToken: string | undefined;
  /** When it was sent, on masters of ours: more than that of each socket and registration before. [EX-51] */
  readonly sentMs?: number | undefined;
}

/** Opens sockets of the topic-data channel to one master. */
export interface TopicDataTransport {
  /**
   * Starts to open a socket. Never throws; failures arrive as `handleClose`. The handler is not called
   * before this has returned.
   */
  open(query: TopicDataQuery, handler: TopicDataHandler): TopicDataSocket;
}
