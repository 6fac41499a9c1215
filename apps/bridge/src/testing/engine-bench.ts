import { encodeRecord } from '@ubii/proto';
import type { DataFormat, RecordInit } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { BridgeEngine } from '../core/engine/bridge-engine.ts';
import { EchoMemory } from '../core/loop/echo-memory.ts';
import { OtherBridges } from '../core/loop/other-bridges.ts';
import { bytesCodec } from '../core/payload/bytes-codec.ts';
import type { ForeignMessage, OutgoingMessage, Sent } from '../core/ports/foreign-system.ts';
import type { MasterListener, TopicMaster } from '../core/ports/topic-master.ts';

/** An engine between a master and a system in memory. */
export function createEngineBench({ returnsMessages = false, isSettled = true } = {}) {
  const clock = new FakeClock();
  const published: [topic: string, value: unknown][] = [];
  const sent: [address: string, text: string | undefined][] = [];
  const listeners = new Map<MasterListener, object>();
  const bridges = new OtherBridges('the broker');
  const answer: { sent: Sent } = { sent: { kind: 'sent' } };
  const master: TopicMaster = {
    ownId: 'bridge',
    publish: (topic, _format, value) => void published.push([topic, value]),
    endTopic: (topic) => void published.push([topic, undefined]),
    subscribe(pattern, listener) {
      listeners.set(listener, pattern);
      return () => void listeners.delete(listener);
    },
  };
  const engine: BridgeEngine<Uint8Array> = new BridgeEngine<Uint8Array>({
    clock,
    codec: bytesCodec,
    master,
    bridges,
    echoes: returnsMessages ? new EchoMemory(clock) : undefined,
    foreign: {
      setMappings: () => {
        if (isSettled) engine.handleSettled();
      },
      send({ address, payload }: OutgoingMessage<Uint8Array>) {
        sent.push([address, payload && new TextDecoder().decode(payload)]);
        return answer.sent;
      },
    },
  });
  return {
    clock,
    engine,
    bridges,
    published,
    sent,
    answer,
    /** What the engine has subscribed to. */
    patterns: () => [...listeners.values()],
    /** Those who listen, in the order in which they came. */
    subscriptions: () => [...listeners.keys()],
    /** A message comes from the other system. */
    receive(
      address: string,
      text: string,
      more: Partial<Pick<ForeignMessage<Uint8Array>, 'isOurs' | 'isKept' | 'timestampMs'>> = {},
    ) {
      const payload = new TextEncoder().encode(text);
      engine.handleMessage({
        address,
        payload,
        sizeBytes: payload.byteLength,
        isEmpty: payload.byteLength === 0,
        isOurs: false,
        isKept: false,
        ...more,
      });
    },
    /** A client publishes. */
    record(
      topic: string,
      value: unknown,
      publisherId = 'ada',
      format: DataFormat = 'double',
      timestampMs?: number,
    ) {
      const bytes = encodeRecord({ topic, format, value, timestampMs } as RecordInit);
      for (const listener of [...listeners.keys()]) {
        listener.onRecord({ topic, bytes, publisherId });
      }
    },
    gone(topic: string) {
      for (const listener of [...listeners.keys()]) listener.onGone(topic);
    },
    forwarder(index: number, direction: 'in' | 'out') {
      return engine.report().mappings[index]![direction]!;
    },
  };
}
