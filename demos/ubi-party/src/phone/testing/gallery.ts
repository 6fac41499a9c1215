import { createApp } from 'vue';
import { PartyPhone } from '../index.ts';
import { nextRoom, type Phase, type Room } from '../../sim/index.ts';
import type { LiveRound } from '../../net/index.ts';
import { FakePhoneLink, FEEDBACK, roomWith, type FakeParty } from './fake-phone-link.ts';

/** Each screen by `?screen=hill&seat=1`; `&lost`, `&lag=148` and what else a party has. */
const query = new URLSearchParams(location.search);
const seat = Number(query.get('seat') ?? 0);
const screen = query.get('screen') ?? 'lobby';
const nowMs = Date.now();

const OTHERS = ['Theo', 'Ines', 'Jonas', 'Sam', 'Lea', 'Maximilian Berg'];
const room = roomWith(seat, OTHERS.slice(0, Number(query.get('others') ?? 6)));

function playing(game: string, phase: Phase, startsInMs = -20_000): Partial<FakeParty> {
  const seats = room.players.map((player) => player.seat);
  return {
    room: { ...room, phase, games: [game, 'hill', 'duel'], endsAtMs: nowMs + 14_000 },
    round: { id: 'r1', game, seed: 1, startsAtMs: nowMs + startsInMs, seats },
  };
}

function played(phase: Phase, games: readonly string[]): Room {
  const order = [seat, ...room.players.map((player) => player.seat).filter((one) => one !== seat)];
  const places = (query.has('second') ? [order[1]!, order[0]!, ...order.slice(2)] : order).map(
    (one) => [one],
  );
  let next: Room = { ...room, phase: 'play', games };
  next = nextRoom(next, { type: 'round-over', places }, nowMs);
  return { ...next, phase };
}

const LIVE = (seats: readonly number[]): LiveRound => ({
  id: 'r1',
  headline: 'Lap 2 of 3',
  corner: { value: '14', label: 'seconds left' },
  rows: seats.map((one, at) => ({
    seat: one,
    place: at + 1,
    isOut: at > 3,
    note: at === 0 ? 'leads' : at > 3 ? 'out' : `+${(at * 0.8).toFixed(1)} s`,
  })),
});

const SCREENS: Readonly<Record<string, () => Partial<FakeParty>>> = {
  join: () => ({
    room: {
      ...room,
      players: room.players.filter((one) => one.seat !== seat),
      isLocked: query.has('locked'),
    },
  }),
  connecting: () => ({ link: 'connecting' }),
  away: () => {
    const players = room.players.filter((one) => one.seat !== seat);
    return {
      room: {
        ...room,
        players: players.map((one, at) => (at < 2 ? { ...one, awaySinceMs: 1 } : one)),
      },
    };
  },
  lobby: () => ({ room }),
  explanation: () => playing(query.get('game') ?? 'race', 'explanation'),
  countdown: () => playing(query.get('game') ?? 'hill', 'countdown', 3000),
  race: () => ({ ...playing('race', 'play'), feedback: FEEDBACK }),
  hill: () => ({
    ...playing('hill', 'play'),
    feedback: {
      ...FEEDBACK,
      place: 1,
      headline: 'You’re king',
      sentence: '11 s with the crown. Stay in the middle.',
      gauge: 0.8,
      isReady: true,
    },
  }),
  out: () => ({
    ...playing('hill', 'play'),
    feedback: {
      ...FEEDBACK,
      place: 5,
      headline: 'You’re out',
      sentence: 'Vote for the next power: left spring, up anchor, right feather.',
      gauge: 0,
      isOut: true,
    },
  }),
  duel: () => ({
    ...playing('duel', 'play'),
    feedback: {
      ...FEEDBACK,
      headline: 'Flag 2 of 5',
      sentence: 'Wait until the flag falls, then press.',
      gauge: 1,
      isReady: true,
    },
  }),
  hunt: () => ({
    ...playing('hunt', 'play'),
    feedback: {
      ...FEEDBACK,
      headline: 'Find a cup',
      sentence: 'Take a photo of a cup.',
      isReady: true,
      question: {
        text: 'cup',
        name: 'a cup',
        leastScore: 0.4,
        prize: '3rd would be +1',
        beganAtMs: 0,
        opensAtMs: 0,
        endsAtMs: 60_000,
      },
    },
  }),
  watch: () => {
    const phase = (query.get('phase') ?? 'play') as Phase;
    const key = 'this-phone';
    const players = room.players.filter((one) => one.seat !== seat);
    const isOver = phase === 'podium' || phase === 'end';
    const party = playing(query.get('game') ?? 'race', phase);
    const base = isOver ? played(phase, ['race', 'hill']) : party.room!;
    return {
      ...party,
      room: {
        ...base,
        players: isOver
          ? base.players.map((one) => (one.seat === seat ? { ...one, key: 'other' } : one))
          : players,
        spectators: [{ key, name: 'Wim' }],
        isLocked: query.has('locked'),
      },
      live: LIVE(players.map((one) => one.seat)),
    };
  },
  lead: () => ({
    room: {
      ...room,
      leader: seat,
      spectators: ['Wim', 'Guest'].map((name) => ({ key: name, name })),
    },
  }),
  waiting: () => {
    const party = playing(query.get('game') ?? 'race', 'play');
    const players = room.players.map((one, at) => ({
      ...one,
      points: (at * 7) % 12,
      isWaiting: one.seat === seat,
    }));
    const seats = players.map((one) => one.seat).filter((one) => one !== seat);
    return { ...party, room: { ...party.room!, players }, live: LIVE(seats) };
  },
  podium: () => ({ room: played('podium', ['race', 'hill']) }),
  end: () => ({ room: played('end', ['race']) }),
};

const link = new FakePhoneLink(
  { lagMs: Number(query.get('lag') ?? 24), ...SCREENS[screen]?.() },
  () => Date.now(),
);
createApp(PartyPhone, { link }).mount('#app');
if (query.has('lost')) link.set({ link: 'lost' });
if (query.has('removed')) link.happens({ type: 'kick', by: 'host', seat });
Object.assign(window, { link });
