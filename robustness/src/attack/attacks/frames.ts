import { AccessRole, encode, encodeRecord } from '@ubii/proto';

import { Witness } from '../../master/witness.ts';
import { pause } from '../../pause.ts';
import { comparison, finding, type Attack, type Finding } from '../attack.ts';
import { FrameFlood, clientFrame } from '../parts/frame-flood.ts';
import type { Outsider } from '../../master/outsider.ts';

const RECORDS = 390_000;
const ATTACK_MS = 10_000;
const PERIOD_MS = 20;
const MAX_HEALTH_P50_MS = 10;
const MAX_HEALTH_P99_MS = 50;
const MAX_RECORD_P99_MS = 50;

/** Frames that cost the master the most, in bytes of one `TopicData`. @param id of the player */
const SHAPES: { readonly [shape: string]: (id: string) => Uint8Array } = {
  'records on its own topic': (id) => manyRecords(`/${id}/a`),
  'records on a topic of others': () => manyRecords('/of/others'),
  'one record of small objects': (id) => {
    const elements = Array.from({ length: RECORDS }, () => ({}));
    return single(encodeRecord({ topic: `/${id}/a`, format: 'object2DList', value: { elements } }));
  },
  'one record of unknown fields': (id) => {
    const record = encodeRecord({ topic: `/${id}/a`, format: 'double', value: 1 });
    // Field 99, which no record has, as a varint.
    return single(Buffer.concat([record, Buffer.alloc(3 * 2_000_000, Buffer.of(0x98, 0x06, 1))]));
  },
};

export const frames: Attack = {
  name: 'frames',
  about: `frames of ${RECORDS} records of one player, for ${ATTACK_MS / 1000} s`,
  async run(world) {
    const findings: Finding[] = [];
    for (const [shape, make] of Object.entries(SHAPES)) {
      const master = await world.startMaster();
      const insider = world.insider(master);
      const witness = await Witness.open(master.endpoints.url);
      world.closeLater(() => witness.close());
      await measure(insider, witness, 1_000);
      const calm = await measure(insider, witness, 2_000);
      const player = world.outsider(master);
      const { token } = await world.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
      const member = await player.join(token);
      const flood = await FrameFlood.open(player, member);
      world.closeLater(() => flood.close());
      const frame = clientFrame(make(member.client.id));
      const cpuBefore = master.figures().cpuMs ?? 0;
      void flood.send(frame);
      const under = await measure(insider, witness, ATTACK_MS);
      const cpuMs = (master.figures().cpuMs ?? 0) - cpuBefore;
      findings.push(
        comparison(`${shape}: frames of ${frame.length} bytes`, `${flood.frames} written`),
        comparison(`${shape}: answers`, `${flood.receivedBytes} bytes`),
        comparison(`${shape}: CPU of the master`, `${Math.round((cpuMs / ATTACK_MS) * 100)} %`),
        comparison(`${shape}: health p50, calm`, fine(calm.health.p50)),
        atMost(`${shape}: health p50`, under.health.p50, MAX_HEALTH_P50_MS),
        atMost(`${shape}: health p99`, under.health.p99, MAX_HEALTH_P99_MS),
        comparison(`${shape}: records of others p50`, fine(under.record.p50)),
        atMost(`${shape}: records of others p99`, under.record.p99, MAX_RECORD_P99_MS),
      );
      await world.clear();
    }
    return findings;
  },
};

interface Quantiles {
  readonly p50: number;
  readonly p99: number;
}

/** How long a question of this machine and a record of others take meanwhile, milliseconds. */
async function measure(
  insider: Outsider,
  witness: Witness,
  durationMs: number,
): Promise<{ health: Quantiles; record: Quantiles }> {
  const endMs = performance.now() + durationMs;
  const repeat = async (act: () => Promise<unknown>): Promise<Quantiles> => {
    const tookMs: number[] = [];
    while (performance.now() < endMs) {
      const begunMs = performance.now();
      await act();
      tookMs.push(performance.now() - begunMs);
      await pause(PERIOD_MS);
    }
    tookMs.sort((a, b) => a - b);
    const at = (part: number): number => tookMs[Math.floor(part * (tookMs.length - 1))]!;
    return { p50: at(0.5), p99: at(0.99) };
  };
  const [health, record] = await Promise.all([
    repeat(() => insider.ask('GET', '/health')),
    repeat(() => witness.check()),
  ]);
  return { health, record };
}

function manyRecords(topic: string): Uint8Array {
  const record = encode('ubii.topicData.TopicDataRecord', { topic, double: 1 });
  const element = Buffer.concat([Buffer.of(0x0a, record.length), record]);
  return lengthDelimited(0x1a, Buffer.alloc(element.length * RECORDS, element));
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

function atMost(what: string, ms: number, maxMs: number): Finding {
  return finding(what, fine(ms), `at most ${maxMs} ms`, ms <= maxMs);
}
