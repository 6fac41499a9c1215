import { createApp, h } from 'vue';
import type { RoundState } from '../../modules/index.ts';
import type { RoomView } from '../../net/index.ts';
import {
  EMPTY_ROOM,
  GAMES,
  type Controls,
  type Game,
  type GameId,
  type Phase,
  type Player,
  type Room,
  type Seat,
} from '../../sim/index.ts';
import PartyScreen from '../PartyScreen.vue';
import type { ScreenLink } from '../screen-link.ts';

/**
 * Shows the whole big screen in any phase, played by bots, without a master:
 * `gallery.html?phase=play&game=race&players=12&step=600&seed=1`. `away=2` lets seat 2 be away, `replay=1` begins the
 * podium with the replay, `people=0` makes all of them bots, `hidden=1` hides the code, `menu=1` opens the host's menu.
 */
const query = new URLSearchParams(location.search);
const number = (name: string, otherwise: number): number => Number(query.get(name) ?? otherwise);
const NAMES = [
  ...['Mara', 'Theo', 'Ines', 'Jo', 'Sam', 'Lin', 'Ravi', 'Eda', 'Maximilian', 'Oleksandra'],
  ...['Al', 'Wilhelmine B.'],
];
const phase = (query.get('phase') ?? 'lobby') as Phase;
const game = (query.get('game') ?? 'race') as GameId;
const rules = GAMES[game] as Game<unknown>;
const seats: readonly Seat[] = Array.from({ length: number('players', 6) }, (_, seat) => seat);
const seed = number('seed', 1);
const isOver = phase === 'podium' || phase === 'end';

function played(): { readonly frames: RoundState[]; readonly last: RoundState } {
  const state = rules.start({ seats, seed });
  const frames: RoundState[] = [];
  const most = phase === 'play' ? number('step', 600) : isOver ? 20_000 : 0;
  let step = 0;
  const frame = (): RoundState => ({
    id: 'round',
    step,
    state: structuredClone(state),
    places: rules.places(state),
    isOver: rules.isOver(state),
  });
  for (; step < most && !rules.isOver(state); step += 1) {
    const controls = new Map<Seat, Controls>(seats.map((seat) => [seat, rules.bot(state, seat)]));
    rules.step(state, (seat) => controls.get(seat)!, rules.settings);
    if (query.get('replay') === '1') frames.push(frame());
  }
  step += 6 - (step % 6);
  return { frames: frames.slice(-240), last: frame() };
}

const { frames, last } = played();
const places = last.places.flat();
const pointsOf = (seat: Seat): number => Math.max(0, 10 - 2 * places.indexOf(seat));
const players: Player[] = seats.map((seat) => ({
  seat,
  name: NAMES[seat] ?? `Bot ${seat + 1}`,
  isWaiting: false,
  isReady: seat % 2 === 0,
  points: isOver ? pointsOf(seat) + ((seat * 7) % 5) : 0,
  ...(seat < number('people', NAMES.length) && { key: `client-${seat}` }),
  ...(query.get('away') === String(seat) && { awaySinceMs: 0 }),
}));
const before = Object.fromEntries(seats.map((seat) => [seat, (seat * 7) % 5]));
const room: Room = {
  ...EMPTY_ROOM,
  phase,
  players,
  games: isOver ? ['race', game, 'hunt'] : [game, 'hill', 'hunt'],
  ...(players[0] && { leader: 0 }),
  isCodeHidden: query.get('hidden') === '1',
  results: isOver
    ? [
        { game: 'race', places: [[1], [0], [2]], points: before },
        {
          game,
          places: last.places,
          points: Object.fromEntries(seats.map((s) => [s, pointsOf(s)])),
        },
      ]
    : [],
  endsAtMs: (phase === 'countdown' ? 2500 : 9000) + 1000,
};
const view: RoomView = {
  room,
  hostId: 'host',
  ...(phase !== 'lobby' && { round: { id: 'round', game, seed, seats, startsAtMs: 0 } }),
  lags: Object.fromEntries(seats.filter((seat) => players[seat]!.key).map((s) => [s, 24 + 7 * s])),
};

const onViews: ((view: RoomView) => void)[] = [];
const onStates: ((game: GameId, state: RoundState) => void)[] = [];
const nothing = (): void => {};
const link: ScreenLink = {
  // A replay is shown when the phase changes
  view: query.get('replay') === '1' ? { ...view, room: { ...room, phase: 'play' } } : view,
  nowMs: () => 1000,
  onView: (fn) => (onViews.push(fn), nothing),
  onState: (fn) => (onStates.push(fn), nothing),
  onPhotos: () => nothing,
  onCheer: () => nothing,
  droppedCheers: 0,
  apply: () => undefined,
  offerSeat: () => 'K7MX',
  setSetting: nothing,
  takeDownPhoto: nothing,
  hidePhotos: nothing,
};
createApp(() =>
  h(PartyScreen, {
    link,
    invitation: {
      address: 'studio.local/party',
      code: 'K7MX4TQA',
      scanned: 'http://studio.local/party/play#join=K7MX4TQA',
    },
    takeAddress: (code: string) => `http://studio.local/party/play#take=${code}`,
  }),
).mount('#app');
for (const frame of phase === 'play' ? [last] : frames) onStates.forEach((fn) => fn(game, frame));
if (frames.length > 0) onViews.forEach((fn) => fn(view));
if (query.get('menu') === '1')
  document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'h', bubbles: true }));
let drawn = 0;
requestAnimationFrame(function onFrame() {
  // The size of a canvas that nobody has drawn on yet
  drawn += Number(document.querySelector('canvas')?.width !== 300);
  if (drawn > number('frames', 8)) document.title = 'ready';
  else requestAnimationFrame(onFrame);
});
