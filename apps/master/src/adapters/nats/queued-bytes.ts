import type { NatsConnection } from '@nats-io/transport-node';

/** The parts of the library's connection that hold bytes. It has no public way to ask; its version is pinned. */
interface Inside {
  readonly protocol: {
    readonly outbound: { size(): number };
    readonly transport?: { readonly socket?: { readonly writableLength: number } };
  };
}

/** Bytes that were published and that the system has not taken yet. */
export function queuedBytesOf(connection: NatsConnection): number {
  const { outbound, transport } = (connection as unknown as Inside).protocol;
  return outbound.size() + (transport?.socket?.writableLength ?? 0);
}
