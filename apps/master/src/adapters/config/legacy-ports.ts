/** The ports existing clients look for. */
export interface LegacyPorts {
  readonly services: number;
  readonly topicData: number;
}

/** Where the original master listens for HTTP and WebSocket: the fallback of `legacyPorts`. */
export const ORIGINAL_PORTS: LegacyPorts = { services: 8102, topicData: 8104 };

/** Where the original master listens for ZeroMQ. */
export const ORIGINAL_ZEROMQ_PORTS: LegacyPorts = { services: 8101, topicData: 8103 };
