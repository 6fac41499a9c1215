import type { PictureSettings } from '../encode-picture.ts';
import { pictureLadder, stepCost, type PictureStep } from './picture-ladder.ts';
import type { SentSummary } from './picture-meter.ts';

/** Measurements for a decision about settings. */
export interface PictureConditions {
  readonly nowMs: number;
  /** `undefined` while too few pictures were sent with the current settings. */
  readonly sent: SentSummary | undefined;
  /** Recent round trips to the master, newest last, milliseconds. */
  readonly roundTripsMs?: readonly number[];
  /** Results of modules per second; `undefined` while there are none. */
  readonly resultHz?: number | undefined;
}

/** State of the controller between decisions. */
export interface AdaptState {
  /** Index in the ladder of settings; 0: the wanted ones. */
  readonly level: number;
  /** Throughput of the network when it was last too slow, bytes per second. */
  readonly linkBytesPerSecond: number | undefined;
  /** Rate of modules if it is below the sent rate, Hz. */
  readonly moduleHz: number | undefined;
  /** Rate that this device can encode within `MAX_ENCODING`, Hz. */
  readonly deviceHz: number | undefined;
  /** Newest encoding time, milliseconds. */
  readonly encodeMs: number | undefined;
  /** Rate of results when the picture rate was last lowered for a module. */
  readonly resultHz: number | undefined;
  readonly lastResultMs: number;
  readonly changedMs: number;
  /** True while more is sent than the known throughput of the network. */
  readonly isProbing: boolean;
  /** The throughput increased: the network has recovered, and higher settings may be tried soon. */
  readonly isRecovered: boolean;
  /** Time without problems before more than the known throughput is tried, milliseconds. */
  readonly probeMs: number;
}

/** Share of the time between two pictures that sending one may take; above, the network is too slow. */
const BUSY_SHARE = 0.7;
/** Largest increase of the round trip, which is how queues of the operating system are noticed, milliseconds. */
const MAX_QUEUE_MS = 250;
/** Share of the throughput that is used: below `BUSY_SHARE`, so that one decision does not cause the next. */
const USED_SHARE = 0.6;
/** Lowest factor of one decision: a stall says nothing about the throughput. */
const MAX_CUT = 0.3;
/** Time until measurements reflect new settings; round trips arrive every two seconds. Milliseconds. */
const SETTLE_MS = 3000;
/** Time without problems before the level is raised, milliseconds. */
const HOLD_MS = 4000;
/** Factor on the throughput from which the network has recovered. */
const RECOVERED = 1.1;
const FIRST_PROBE_MS = 15_000;
const MAX_PROBE_MS = 120_000;
/** Share of the time that a device may spend encoding pictures. */
const MAX_ENCODING = 0.6;
/** Factor on the rate of modules, so that they never wait for a picture. */
const HEADROOM = 1.1;
/** Ratios of results to pictures: below, the rate is lowered; above `MANY_RESULTS`, a higher one is tried. */
const FEW_RESULTS = 0.85;
const MANY_RESULTS = 0.95;
const MORE = 1.1;
const MUCH_MORE = 1.5;
const MIN_HZ = 0.5;
/** Results missing at the time of counting; not a sign of a slow module, Hz. */
const MISSED_HZ = 0.35;
/** Rate below which a missing result does not prevent trying a higher rate, Hz. */
const FEW_HZ = 2;
const FEW_MISSED_HZ = 0.2;
/** Time without results after which there is no module, milliseconds. */
const NO_MODULE_MS = 6000;

export const FIRST_STATE: AdaptState = {
  level: 0,
  linkBytesPerSecond: undefined,
  moduleHz: undefined,
  deviceHz: undefined,
  encodeMs: undefined,
  resultHz: undefined,
  lastResultMs: 0,
  changedMs: 0,
  isProbing: false,
  isRecovered: false,
  probeMs: FIRST_PROBE_MS,
};

/** Returns the settings to send with: never above the wanted ones. */
export function adaptedStep(state: AdaptState, wanted: Readonly<PictureSettings>): PictureStep {
  const ladder = pictureLadder(wanted);
  const { width, quality, rateHz } = ladder[Math.min(state.level, ladder.length - 1)]!;
  const limits = [rateHz, state.moduleHz ?? Infinity, state.deviceHz ?? Infinity];
  return { width, quality, rateHz: Math.min(...limits) };
}

/**
 * Decides about the settings, about twice a second. The network determines the level: down according to the throughput
 * (multiplicative), up one level at a time (additive), and to a level that was too slow before only after a time
 * without problems that doubles with each failure. Modules and this device determine the rate only: their speed hardly
 * depends on quality and size.
 */
export function adaptPictures(
  state: AdaptState,
  wanted: Readonly<PictureSettings>,
  conditions: PictureConditions,
): AdaptState {
  return followDevice(
    followModule(followLink(state, wanted, conditions), wanted, conditions),
    conditions,
  );
}

function followLink(
  before: AdaptState,
  wanted: Readonly<PictureSettings>,
  conditions: PictureConditions,
): AdaptState {
  const { nowMs, sent, roundTripsMs = [] } = conditions;
  const ladder = pictureLadder(wanted);
  const level = Math.min(before.level, ladder.length - 1);
  const state = { ...before, level };
  const sinceMs = nowMs - state.changedMs;
  if (sent === undefined || sinceMs < SETTLE_MS) return state;
  const { rateHz } = adaptedStep(state, wanted);
  const busyShare = (sent.leaveMs * rateHz) / 1000;
  const offered = sent.bytes * rateHz;
  const taken = sent.bytesPerSecond;
  // A queue shorter than the interval between pictures is empty when the next one is sent.
  const maxQueueMs = Math.max(MAX_QUEUE_MS, (USED_SHARE * 1000) / rateHz);
  if (busyShare > BUSY_SHARE || queueMs(roundTripsMs) > maxQueueMs) {
    const share = Math.max((USED_SHARE * taken) / offered, MAX_CUT);
    // A failed attempt to increase: the previous level was sustainable.
    const isBorne = state.isProbing && level + 1 < ladder.length;
    const next = isBorne ? level + 1 : levelFor(ladder, level, share);
    const probeMs = state.isProbing ? Math.min(2 * state.probeMs, MAX_PROBE_MS) : state.probeMs;
    const link = { linkBytesPerSecond: taken, isProbing: false, isRecovered: false, probeMs };
    return { ...state, ...link, level: next, changedMs: next === level ? state.changedMs : nowMs };
  }
  const { linkBytesPerSecond: known = Infinity } = state;
  if (state.isProbing && sinceMs >= 2 * HOLD_MS) {
    if (taken <= RECOVERED * known) return { ...state, isProbing: false };
    return { ...state, isProbing: false, isRecovered: true, probeMs: FIRST_PROBE_MS };
  }
  if (level === 0) return state;
  const growth = stepCost(ladder[level - 1]!) / stepCost(ladder[level]!);
  const isKnownToFit = offered * growth <= USED_SHARE * known;
  const calmMs = isKnownToFit || state.isRecovered ? HOLD_MS : state.probeMs;
  if (busyShare * growth > USED_SHARE || sinceMs < calmMs) return state;
  return { ...state, level: level - 1, changedMs: nowMs, isProbing: !isKnownToFit };
}

/**
 * Estimates the queueing delay in the operating system. Uses the shorter of the last two round trips, because a single
 * long one may be a stall.
 */
function queueMs(roundTripsMs: readonly number[]): number {
  if (roundTripsMs.length < 2) return 0;
  return Math.min(...roundTripsMs.slice(-2)) - Math.min(...roundTripsMs);
}

/** Returns the first lower level that costs at most a share of this one; otherwise the last level. */
function levelFor(ladder: readonly PictureStep[], level: number, share: number): number {
  const most = share * stepCost(ladder[level]!);
  const found = ladder.findIndex((step, index) => index > level && stepCost(step) <= most);
  return found === -1 ? ladder.length - 1 : found;
}

function followModule(
  state: AdaptState,
  wanted: Readonly<PictureSettings>,
  { nowMs, sent, resultHz }: PictureConditions,
): AdaptState {
  if (resultHz === undefined) {
    const isGone = nowMs - state.lastResultMs > NO_MODULE_MS;
    return isGone ? { ...state, moduleHz: undefined, resultHz: undefined } : state;
  }
  const seen = { ...state, lastResultMs: nowMs };
  if (sent === undefined) return seen;
  if (resultHz < sent.rateHz * FEW_RESULTS - MISSED_HZ) {
    const moduleHz = Math.max(MIN_HZ, resultHz * HEADROOM);
    // The rate may have been lowered already, while measurements still include earlier pictures.
    if (state.moduleHz !== undefined && moduleHz >= state.moduleHz) return seen;
    return { ...seen, moduleHz, resultHz };
  }
  const fewMissed = sent.rateHz < FEW_HZ ? FEW_MISSED_HZ : 0;
  if (state.moduleHz === undefined || resultHz < sent.rateHz * MANY_RESULTS - fewMissed)
    return seen;
  // From very low rates, such as after a slow start of a module, increase in larger steps.
  const next = state.moduleHz * (state.moduleHz < FEW_HZ ? MUCH_MORE : MORE);
  if (next >= wanted.rateHz) return { ...seen, moduleHz: undefined, resultHz: undefined };
  return { ...seen, moduleHz: next, resultHz };
}

function followDevice(state: AdaptState, { sent }: PictureConditions): AdaptState {
  if (sent === undefined) return state;
  // Increases slowly: a single long encoding time says little.
  const { encodeMs: before = sent.encodeMs } = state;
  const encodeMs = Math.min(sent.encodeMs, before + (sent.encodeMs - before) / 4);
  const deviceHz = encodeMs > 0 ? (1000 * MAX_ENCODING) / encodeMs : undefined;
  return { ...state, encodeMs, deviceHz };
}
