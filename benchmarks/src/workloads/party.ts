import { setTimeout as sleep } from 'node:timers/promises';
import { MasterProcess } from '@ubii/harness';
import { phoneTopic } from '@ubii/party/net';
import { PartyRoom } from '../party/party-room.ts';
import { percentile } from '../statistics.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Subject, Workload } from '../measuring/workload.ts';

const STEP_MS = 1000 / 60;
/** A record that passes, and the step of the game that it waits for: no game that runs in steps is faster. */
const REFERENCE = 'passing + a step';
const PASSING = 'passing';
const GAME = 'game';
/** A press comes at any moment of a step. */
const BETWEEN_PRESSES_MS = 61;
const GIVE_UP_MS = 2000;

/** From the press of a button to the state that shows it, while 32 phones steer at 60 Hz. */
export const party: Workload = {
  name: 'party',
  group: 'party',
  title: 'Ubi-Party: press on a phone -> state of the game at the screen, 32 phones at 60 Hz',
  figures: [
    { key: 'p50Ms', label: 'p50', unit: 'ms', isHigherBetter: false, goals: {} },
    {
      key: 'p99Ms',
      label: 'p99',
      unit: 'ms',
      isHigherBetter: false,
      goals: { [GAME]: 2 },
      bounds: { [GAME]: 50 },
    },
    { key: 'cores', label: 'master CPU', unit: 'cores', isHigherBetter: false, goals: {} },
  ],
  reference: REFERENCE,
  placement: 'anywhere',
  roundShare: 1 / 3,
  open: async ({ parts, master: file, profileDir }) => {
    const master = await parts.get('master', () =>
      MasterProcess.start({ program: file, profileDir }),
    );
    const room = await parts.get('party room', () => PartyRoom.open(master));
    const subject = (name: string, press: (room: PartyRoom) => Promise<number>): Subject => ({
      name,
      pids: [master.pid],
      measure: (options) => measurePresses(master, room, press, options),
    });
    return [subject(PASSING, passRecord), subject(GAME, pressButton)];
  },
  derive: (round) => {
    const passing = round[PASSING]!;
    const { p50Ms, p99Ms, cores } = passing.figures as Record<string, number>;
    const figures = { p50Ms: p50Ms! + STEP_MS / 2, p99Ms: p99Ms! + STEP_MS, cores: cores! };
    return { [REFERENCE]: { ...passing, figures } };
  },
};

async function measurePresses(
  master: MasterProcess,
  room: PartyRoom,
  press: (room: PartyRoom) => Promise<number>,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  room.play();
  await sleep(500 + warmUpMs);
  const stopLap = startLap([master.pid]);
  const beganMs = performance.now();
  const tookMs: number[] = [];
  let lost = 0;
  while (performance.now() - beganMs < measureMs) {
    const took = await press(room);
    if (Number.isNaN(took)) lost += 1;
    else tookMs.push(took);
    await sleep(BETWEEN_PRESSES_MS);
  }
  const lap = stopLap();
  const sorted = Float64Array.from(tookMs).sort();
  return {
    figures: {
      p50Ms: percentile(sorted, 0.5),
      p99Ms: percentile(sorted, 0.99),
      cores: lap.cpuUs / 1000 / (performance.now() - beganMs),
    },
    deliveries: tookMs.length,
    otherCpuShare: lap.otherCpuShare,
    faults: lost > 0 ? [`${lost} presses were not seen within ${GIVE_UP_MS} ms`] : [],
  };
}

/** Milliseconds until a press of the next phone charges its piece in the state that the screen has; NaN: never. */
async function pressButton(room: PartyRoom): Promise<number> {
  const seat = room.nextSeat();
  const phone = room.phones[seat]!;
  const topic = phoneTopic(phone.id, 'button');
  const beganMs = performance.now();
  const charged = new Promise<boolean>((resolve) => {
    const timer = setTimeout(() => resolve(false), GIVE_UP_MS);
    room.onState = ({ state }) => {
      if (state.pieces[seat]!.charge === 0) return;
      clearTimeout(timer);
      resolve(true);
    };
  });
  phone.publish(topic, 'bool', true, { immediate: true });
  const took = (await charged) ? performance.now() - beganMs : Number.NaN;
  phone.publish(topic, 'bool', false, { immediate: true });
  return took;
}

/** Milliseconds for a record from a phone to the screen, under the same load. */
async function passRecord(room: PartyRoom): Promise<number> {
  const phone = room.phones[room.nextSeat()]!;
  const topic = `/${phone.id}/passing`;
  const subscription = room.screen.subscribe(topic, { format: 'double' });
  await subscription.ready;
  const came = new Promise<boolean>((resolve) => {
    const timer = setTimeout(() => resolve(false), GIVE_UP_MS);
    subscription.onRecord(() => {
      clearTimeout(timer);
      resolve(true);
    });
  });
  const beganMs = performance.now();
  phone.publish(topic, 'double', beganMs, { immediate: true });
  const took = (await came) ? performance.now() - beganMs : Number.NaN;
  phone.endTopic(topic);
  await subscription.close();
  return took;
}
