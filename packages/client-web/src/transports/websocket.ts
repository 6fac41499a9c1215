import type {
  TopicDataQuery,
  TopicDataSocket,
  TopicDataTransport,
} from '../core/ports/topic-data-transport.ts';

/** The used members of a WHATWG WebSocket, as in browsers and in the ws package. */
export interface WebSocketLike {
  binaryType: string;
  readonly readyState: number;
  readonly bufferedAmount: number;
  send(data: string | Uint8Array<ArrayBuffer>): void;
  close(code?: number, reason?: string): void;
  addEventListener(type: 'open' | 'error', listener: () => void): void;
  addEventListener(type: 'message', listener: (event: { data: unknown }) => void): void;
  addEventListener(
    type: 'close',
    listener: (event: { code: number; reason: string }) => void,
  ): void;
}

/** Opens a WebSocket. */
export type OpenWebSocket = (url: string) => WebSocketLike;

const OPEN = 1;

/**
 * Topic data over a WebSocket. [TD-1]
 * @param url such as `ws://localhost:8080/topicdata`; a query it has is kept
 */
export function createWebSocketTopicData(
  url: string,
  openWebSocket: OpenWebSocket,
): TopicDataTransport {
  return {
    open(query, handler) {
      let isOver = false;
      const handleClose = (code: number, reason: string): void => {
        if (isOver) return;
        isOver = true;
        handler.handleClose(code, reason);
      };

      let socket: WebSocketLike;
      try {
        socket = openWebSocket(withQuery(url, query));
      } catch (error) {
        // A URL that is none, or a page that may not: reported like every other failure.
        void Promise.resolve().then(() => handleClose(1006, String(error)));
        return CLOSED_SOCKET;
      }
      socket.binaryType = 'arraybuffer';
      socket.addEventListener('open', () => handler.handleOpen());
      socket.addEventListener('message', ({ data }) => {
        if (isOver) return;
        if (typeof data === 'string') handler.handleText(data);
        else if (data instanceof ArrayBuffer) handler.handleBinary(new Uint8Array(data));
      });
      socket.addEventListener('close', ({ code, reason }) => handleClose(code, reason));
      // "close" follows with all information; ws throws when "error" has no listener.
      socket.addEventListener('error', () => undefined);

      return {
        sendBinary(borrowedBytes) {
          // A shared buffer is the one kind a WebSocket does not take; no codec makes such bytes.
          if (socket.readyState === OPEN) socket.send(borrowedBytes as Uint8Array<ArrayBuffer>);
        },
        sendText(text) {
          if (socket.readyState === OPEN) socket.send(text);
        },
        get bufferedBytes() {
          return socket.bufferedAmount;
        },
        close(code = 1000, reason = '') {
          socket.close(code, reason);
          // Closing takes a handshake with a master that may be gone; who closes has no use for waiting.
          void Promise.resolve().then(() => handleClose(code, reason));
        },
      };
    },
  };
}

const CLOSED_SOCKET: TopicDataSocket = {
  sendBinary: () => undefined,
  sendText: () => undefined,
  bufferedBytes: 0,
  close: () => undefined,
};

/** The client's id comes last: existing masters and proxies look for it at the end. [EX-4] */
function withQuery(url: string, { clientId, resumeToken, sentMs }: TopicDataQuery): string {
  const token = resumeToken === undefined ? '' : `token=${encodeURIComponent(resumeToken)}&`;
  const sent = sentMs === undefined ? '' : `sent=${sentMs}&`;
  const separator = url.includes('?') ? '&' : '?';
  return `${url}${separator}${token}${sent}clientID=${encodeURIComponent(clientId)}`;
}
