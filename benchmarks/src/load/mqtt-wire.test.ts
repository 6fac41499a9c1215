import { describe, expect, it } from 'vitest';
import { DeliveryVerifier } from './delivery-verifier.ts';
import { greetMqtt, MQTT } from './mqtt-wire.ts';
import { createRecordRing } from './record-ring.ts';

const ring = createRecordRing('mqtt', 100, 512);
const PING_RESPONSE = Buffer.from([0xd0, 0]);

describe('records over MQTT', () => {
  it('are published with their topic and content', () => {
    const published = MQTT.published(ring).slice(3, 1);
    const content = ring.messages.slice(3, 1);
    expect(published[0]).toBe(0x30);
    expect(published.includes(Buffer.from(ring.topic))).toBe(true);
    expect(published.subarray(-content.length)).toEqual(content);
  });

  it('are accepted in whatever chunks they come, and counted when they are missing or altered', () => {
    const message = (sequence: number): Buffer =>
      Buffer.from(MQTT.delivered(ring).slice(sequence, 1));
    const altered = message(4);
    altered[altered.length - 1]! ^= 1;
    const stream = Buffer.concat([message(0), PING_RESPONSE, message(1), message(3), altered]);
    for (let cut = 1; cut < stream.length; cut += 7) {
      const verifier = new DeliveryVerifier(ring, MQTT);
      for (const chunk of [stream.subarray(0, cut), stream.subarray(cut)]) verifier.push(chunk);
      expect(verifier.faults).toEqual({ lost: 1, altered: 1, repeated: 0, unexpected: [] });
    }
  });

  it('are subscribed to in the greeting, whose answer may come in parts', () => {
    const { hello, answerEnd } = greetMqtt('Broker', 1883, ring.topic);
    expect(hello.includes(Buffer.from(ring.topic))).toBe(true);
    expect([3, 8, 9, 20].map((bytes) => answerEnd(Buffer.alloc(bytes)))).toEqual([
      ...[undefined, undefined, 9, 9],
    ]);
    expect(greetMqtt('Broker', 1883, undefined).answerEnd(Buffer.alloc(4))).toBe(4);
  });
});
