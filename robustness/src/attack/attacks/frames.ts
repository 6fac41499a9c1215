import { mib } from '@ubii/harness';
import { AccessRole, encode, encodeRecord } from '@ubii/proto';

import { comparison, finding, type Attack, type Finding } from '../attack.ts';
import { FrameFlood, clientFrames } from '../parts/frame-flood.ts';
import { DelayMeter } from '../environment/delay-meter.ts';

const RECORDS = 390_000;
const ATTACK_MS = 10_000;
const WARM_UP_MS = 1_000;
const CALM_MS = 2_000;
/** A busy machine is slower by itself: twice as much as before is as good. */
const MAX_HEALTH_P50_MS = 10;
const MAX_HEALTH_P99_MS = 50;
const MAX_RECORD_P99_MS = 50;

/** Frames that cost the master the most, in bytes of one `TopicData`. @param id of the player */
const SHAPES: { readonly [shape: string]: (id: string) => Uint8Array } = {
  [`${RECORDS} records`]: (id) => manyRecords(`/${id}/a`, RECORDS),
  [`${RECORDS} records on a topic of others`]: () => manyRecords('/others', RECORDS),
  '150000 records': (id) => manyRecords(`/${id}/a`, 150_000),
  '4096 records': (id) => manyRecords(`/${id}/a`, 4_096),
  'one record': (id) => manyRecords(`/${id}/a`, 1),
  'a record of small objects': (id) => {
    const elements = Array.from({ length: RECORDS }, () => ({}));
    return single(encodeRecord({ topic: `/${id}/a`, format: 'object2DList', value: { elements } }));
  },
  'a record of unknown fields': (id) => {
    const record = encodeRecord({ topic: `/${id}/a`, format: 'double', value: 1 });
    // Field 99, which no record has, as a varint.
    return single(Buffer.concat([record, Buffer.alloc(3 * 2_000_000, Buffer.of(0x98, 0x06, 1))]));
  },
};

export const frames: Attack = {
  name: 'frames',
  about: `frames of ${RECORDS} records of one player, for ${ATTACK_MS / 1000} s`,
  async run(environment) {
    const findings: Finding[] = [];
    for (const [shape, make] of Object.entries(SHAPES)) {
      const master = await environment.startMaster();
      const meter = await DelayMeter.open(master.endpoints.url);
      environment.closeLater(() => meter.close());
      await meter.during(WARM_UP_MS);
      const calm = await meter.during(CALM_MS);
      const player = environment.outsider(master);
      const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
      const member = await player.join(token);
      const flood = new FrameFlood(player, member);
      environment.closeLater(() => flood.close());
      const frame = clientFrames(make(member.client.id));
      const cpuBefore = master.figures().cpuMs ?? 0;
      const sent = flood.send(frame);
      const under = await Promise.race([
        meter.during(ATTACK_MS),
        sent.then(() => Promise.reject(new Error('The player stopped sending.'))),
      ]);
      const cpuMs = (master.figures().cpuMs ?? 0) - cpuBefore;
      const perSecond = flood.sentBytes / (ATTACK_MS / 1000);
      findings.push(
        comparison(`${shape}: taken from the player`, `${mib(perSecond)} a second`),
        comparison(`${shape}: connections of the player`, String(flood.connections)),
        comparison(`${shape}: CPU of the master`, `${Math.round((cpuMs / ATTACK_MS) * 100)} %`),
        comparison(`${shape}: health p50 before`, fine(calm.health.p50)),
        atMost(`${shape}: health p50`, under.health.p50, MAX_HEALTH_P50_MS, calm.health.p50),
        atMost(`${shape}: health p99`, under.health.p99, MAX_HEALTH_P99_MS, calm.health.p99),
        comparison(`${shape}: records of others p50`, fine(under.record.p50)),
        atMost(
          `${shape}: records of others p99`,
          under.record.p99,
          MAX_RECORD_P99_MS,
          calm.record.p99,
        ),
      );
      await environment.clear();
    }
    return findings;
  },
};

function manyRecords(topic: string, count: number): Uint8Array {
  const record = encode('ubii.topicData.TopicDataRecord', { topic, double: 1 });
  const element = Buffer.concat([Buffer.of(0x0a, record.length), record]);
  return lengthDelimited(0x1a, Buffer.alloc(element.length * count, element));
}

function single(record: Uint8Array): Uint8Array {
  return lengthDelimited(0x12, record);
}

function lengthDelimited(tag: number, bytes: Uint8Array): Uint8Array {
  const head = [tag];
  let rest = bytes.length;
  for (; rest >= 0x80; rest >>>= 7) head.push((rest & 0x7f) | 0x80);
  return Buffer.concat([Buffer.of(...head, rest), bytes]);
}

function fine(ms: number): string {
  return `${ms.toFixed(1)} ms`;
}

function atMost(what: string, ms: number, maxMs: number, beforeMs: number): Finding {
  const holds = ms <= Math.max(maxMs, 2 * beforeMs);
  return finding(what, fine(ms), `at most ${maxMs} ms, or as before it`, holds);
}
