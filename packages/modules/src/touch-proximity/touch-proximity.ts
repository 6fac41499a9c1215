import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** State of one client that touches. */
interface Toucher {
  isNear: boolean;
  /** No new vibration until this module time, milliseconds. */
  quietUntilMs: number;
  /** `isNear` is not repeated until this module time, milliseconds. */
  toldUntilMs: number;
}

interface TouchProximityState {
  /** Milliseconds since the first run. */
  nowMs: number;
  /** By identity. */
  touchers: { [identity: string]: Toucher };
  /** By topic: stamp of the newest record, and when it arrived. */
  seen: { [topic: string]: { stamp: string; sinceMs: number } };
}

/**
 * Makes phones vibrate that are touched at nearly the same position: the muxer example of the paper on
 * Ubi-Interact (section 5.6). A muxer collects the positions of all phones with their identities; a
 * demuxer publishes the results for each phone.
 */
export const touchProximity = defineProcessingModule({
  name: 'touch-proximity',
  description: 'Detects near touches, and vibrates their phones.',
  tags: ['touch', 'muxer', 'demuxer', 'example'],
  authors: ['Ubi-Interact'],
  version: '1.1.0',
  inputs: {
    touches: {
      format: 'vector2',
      list: true,
      description: 'Touch positions of all clients, 0 to 1 of width and height.',
    },
    touching: {
      format: 'bool',
      list: true,
      description: 'Whether each client touches; without a value, its newest position counts.',
    },
    distance: {
      format: 'double',
      default: 0.1,
      description: 'Touches within this distance are near, in units of the positions.',
    },
    hysteresis: {
      format: 'double',
      default: 0.02,
      description:
        'Additional distance at which near touches stay near, in units of the positions.',
    },
    vibrationMs: {
      format: 'double',
      default: 100,
      description: 'Duration of the vibration, 0 to 10 000 ms; 0 turns vibration off.',
    },
    maxAgeMs: {
      format: 'double',
      default: 2000,
      description: 'Time in ms after which a touch without a new value has ended; 0: no limit.',
    },
  },
  outputs: {
    vibration: {
      format: 'double',
      list: true,
      description: 'Duration of the vibration for each client near another one, ms.',
    },
    isNear: { format: 'bool', list: true, description: 'True for each client near another one.' },
    nearCount: { format: 'int32', description: 'Number of clients near another one.' },
  },
  mode: { frequency: { hertz: 20 } },
  createState: (): TouchProximityState => ({
    nowMs: 0,
    touchers: Object.create(null) as TouchProximityState['touchers'],
    seen: Object.create(null) as TouchProximityState['seen'],
  }),
  onProcessing(deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
    };
    const distance = read.number(inputs.distance, 0.1, 0, 1e9);
    const farDistance = distance + read.number(inputs.hysteresis, 0.02, 0, 1e9);
    const vibrationMs = read.number(inputs.vibrationMs, 100, 0, 10_000);
    const maxAgeMs = read.number(inputs.maxAgeMs, 2000, 0, Number.MAX_VALUE);
    state.nowMs += deltaTimeMs;

    // Clients that report a lifted finger. For other clients, a touch ends when its position is too old.
    const lifted = Object.create(null) as { [identity: string]: boolean };
    for (const { identity, bool } of inputs.touching?.elements ?? []) {
      if (identity !== undefined) lifted[identity] = !bool;
    }
    // Clocks of phones differ, so that the age of a touch counts from its arrival.
    const touches: { identity: string; x: number; y: number }[] = [];
    const seen = Object.create(null) as TouchProximityState['seen'];
    // An unmapped input has no list.
    for (const element of inputs.touches?.elements ?? []) {
      const { identity, topic, timestamp, vector2 } = element;
      if (identity === undefined || identity === '' || lifted[identity] === true) continue;
      if (!Number.isFinite(vector2.x) || !Number.isFinite(vector2.y)) continue;
      const { seconds, nanos, millis } = timestamp ?? { seconds: 0, nanos: 0, millis: 0 };
      const stamp = [seconds, nanos, millis, vector2.x, vector2.y].join();
      const before = state.seen[topic];
      const sinceMs = before?.stamp === stamp ? before.sinceMs : state.nowMs;
      seen[topic] = { stamp, sinceMs };
      if (maxAgeMs > 0 && state.nowMs - sinceMs > maxAgeMs) continue;
      touches.push({ identity, x: vector2.x, y: vector2.y });
    }
    state.seen = seen;

    // Sort by x, so that each touch is compared only with the touches close behind it.
    touches.sort((a, b) => a.x - b.x);
    const near = Object.create(null) as { [identity: string]: true };
    for (const [index, a] of touches.entries()) {
      for (let other = index + 1; other < touches.length; other++) {
        const b = touches[other]!;
        if (b.x - a.x > farDistance) break;
        const squared = (b.x - a.x) ** 2 + (b.y - a.y) ** 2;
        if (squared > farDistance ** 2 || a.identity === b.identity) continue;
        // A pair that is near stays near up to the farther distance.
        const needsBefore = squared > distance ** 2;
        if (needsBefore && !state.touchers[a.identity]?.isNear) continue;
        if (needsBefore && !state.touchers[b.identity]?.isNear) continue;
        near[a.identity] = true;
        near[b.identity] = true;
      }
    }

    const touchers = Object.create(null) as TouchProximityState['touchers'];
    const changed: { bool: boolean; outputTopicParams: string[] }[] = [];
    const vibrating: { double: number; outputTopicParams: string[] }[] = [];
    for (const identity of new Set(touches.map((touch) => touch.identity))) {
      const before = state.touchers[identity];
      const isNear = near[identity] === true;
      let quietUntilMs = before?.quietUntilMs ?? 0;
      let toldUntilMs = before?.toldUntilMs ?? 0;
      // Repeat a true value, because a stopped session does not publish false.
      const isDue = isNear && state.nowMs >= toldUntilMs;
      if (isDue || isNear !== (before?.isNear ?? false)) {
        changed.push({ bool: isNear, outputTopicParams: [identity] });
        toldUntilMs = state.nowMs + 500;
      }
      if (isNear && vibrationMs > 0 && state.nowMs >= quietUntilMs) {
        vibrating.push({ double: vibrationMs, outputTopicParams: [identity] });
        quietUntilMs = state.nowMs + vibrationMs;
      }
      touchers[identity] = { isNear, quietUntilMs, toldUntilMs };
    }
    // Clients that lifted the finger or left are not near any more.
    for (const [identity, toucher] of Object.entries(state.touchers)) {
      if (toucher.isNear && touchers[identity] === undefined) {
        changed.push({ bool: false, outputTopicParams: [identity] });
      }
    }
    state.touchers = touchers;

    return {
      outputs: {
        vibration: { elements: vibrating },
        isNear: { elements: changed },
        nearCount: { int32: Object.keys(near).length },
      },
    };
  },
});
