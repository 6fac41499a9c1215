import type { PictureSettings } from '../encode-picture.ts';
import { pictureLadder, stepCost, type PictureStep } from './picture-ladder.ts';
import type { SentSummary } from './picture-meter.ts';

/** What is known when settings are decided on. */
export interface PictureConditions {
  readonly nowMs: number;
  /** `undefined` while too few pictures left with the present settings. */
  readonly sent: SentSummary | undefined;
  /** Round trips to the master of late, the newest last, milliseconds. */
  readonly roundTripsMs?: readonly number[];
  /** Results a second; `undefined` while nothing gives results. */
  readonly resultHz?: number | undefined;
}

/** What a controller remembers from one decision to the next. */
export interface AdaptState {
  /** Place on the ladder, 0 for what is wanted. */
  readonly level: number;
  /** What the link took when it was too slow last, bytes per second. */
  readonly linkBytesPerSecond: number | undefined;
  /** What modules take, if it is less than what is sent, hertz. */
  readonly moduleHz: number | undefined;
  /** What this device encodes without being busy with nothing else, hertz. */
  readonly deviceHz: number | undefined;
  /** The newest measured encoding time, milliseconds. */
  readonly encodeMs: number | undefined;
  /** Results a second when the rate was lowered for the module last. */
  readonly resultHz: number | undefined;
  readonly lastResultMs: number;
  readonly changedMs: number;
  /** More is sent than the link was seen to take. */
  readonly isProbing: boolean;
  /** The link took more than before: it has recovered, and more may be tried soon. */
  readonly isRecovered: boolean;
  /** Calm time before more is tried than the link was seen to take, milliseconds. */
  readonly probeMs: number;
}

/** Of the time between two pictures, one may take this much to leave; beyond it the link is too slow. */
const BUSY_SHARE = 0.7;
/** Queues in the system show in the round trip only, milliseconds. */
const MAX_QUEUE_MS = 250;
/** What is used of what the link takes: less than `BUSY_SHARE`, or every decision would ask for the next. */
const USED_SHARE = 0.6;
/** The most that one decision takes away: a stall is not the measure of a link. */
const MAX_CUT = 0.3;
/** Until figures are those of new settings; round trips come every two seconds. Milliseconds. */
const SETTLE_MS = 3000;
/** Calm time before a level up, milliseconds. */
const HOLD_MS = 4000;
/** A link that takes this much more than before has recovered. */
const RECOVERED = 1.1;
const FIRST_PROBE_MS = 15_000;
const MAX_PROBE_MS = 120_000;
/** Share of its time that a device may encode pictures. */
const MAX_ENCODING = 0.6;
/** A module is sent a few more pictures than it looks at, so that it never waits for one. */
const HEADROOM = 1.1;
/** Fewer results for the pictures sent, and fewer are sent; more, and more are tried; in between nothing changes. */
const FEW_RESULTS = 0.85;
const MANY_RESULTS = 0.95;
const MORE = 1.1;
const MUCH_MORE = 1.5;
const LEAST_HZ = 0.5;
/** One result is often missing when those of the last seconds are counted: so much is no sign of a slow module, hertz. */
const MISSED_HZ = 0.35;
/** Of so few pictures a second, one that is missing is no sign that no more can be tried either. */
const FEW_HZ = 2;
const FEW_MISSED_HZ = 0.2;
/** Without results for this long there is no module, milliseconds. */
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

/** The settings to send with: never more than what is wanted. */
export function adaptedStep(state: AdaptState, wanted: Readonly<PictureSettings>): PictureStep {
  const ladder = pictureLadder(wanted);
  const { width, quality, rateHz } = ladder[Math.min(state.level, ladder.length - 1)]!;
  const limits = [rateHz, state.moduleHz ?? Infinity, state.deviceHz ?? Infinity];
  return { width, quality, rateHz: Math.min(...limits) };
}

/**
 * Decides again, about twice a second. The link decides on the level: down by what it takes (multiplicative), up one
 * level at a time (additive), and where it was too slow before only after a calm time that doubles with every failure.
 * Modules and this device decide on the rate alone: what they take hardly depends on quality and size.
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
  // A queue shorter than the time between two pictures is empty again when the next one comes.
  const maxQueueMs = Math.max(MAX_QUEUE_MS, (USED_SHARE * 1000) / rateHz);
  if (busyShare > BUSY_SHARE || queueMs(roundTripsMs) > maxQueueMs) {
    const share = Math.max((USED_SHARE * taken) / offered, MAX_CUT);
    // An attempt at more has failed: the level before was borne.
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

/** What waits in queues of the system, in time. A single long round trip may be a stall: the shorter of the last two counts. */
function queueMs(roundTripsMs: readonly number[]): number {
  if (roundTripsMs.length < 2) return 0;
  return Math.min(...roundTripsMs.slice(-2)) - Math.min(...roundTripsMs);
}

/** The first level below this one that costs no more than a share of it; the last one when none does. */
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
    const moduleHz = Math.max(LEAST_HZ, resultHz * HEADROOM);
    // It may have been lowered already, and the pictures of before be in the figures still.
    if (state.moduleHz !== undefined && moduleHz >= state.moduleHz) return seen;
    return { ...seen, moduleHz, resultHz };
  }
  const fewMissed = sent.rateHz < FEW_HZ ? FEW_MISSED_HZ : 0;
  if (state.moduleHz === undefined || resultHz < sent.rateHz * MANY_RESULTS - fewMissed)
    return seen;
  // From a rate that is far below what modules usually take, a start that was slow, larger steps lead back.
  const next = state.moduleHz * (state.moduleHz < FEW_HZ ? MUCH_MORE : MORE);
  if (next >= wanted.rateHz) return { ...seen, moduleHz: undefined, resultHz: undefined };
  return { ...seen, moduleHz: next, resultHz };
}

function followDevice(state: AdaptState, { sent }: PictureConditions): AdaptState {
  if (sent === undefined) return state;
  // Up a little at a time: one long picture says little.
  const { encodeMs: before = sent.encodeMs } = state;
  const encodeMs = Math.min(sent.encodeMs, before + (sent.encodeMs - before) / 4);
  const deviceHz = encodeMs > 0 ? (1000 * MAX_ENCODING) / encodeMs : undefined;
  return { ...state, encodeMs, deviceHz };
}
