import '@fontsource-variable/bricolage-grotesque/wdth.css';
import { createApp, h } from 'vue';
import coffee from '../../../../../packages/vision/photos/coffee.jpg?url';
import type { Photo } from '../../net/index.ts';
import { huntGame } from '../../sim/hunt/hunt-game.ts';
import type { Answer, Player } from '../../sim/index.ts';
import HuntScene from '../hunt/HuntScene.vue';
import '../screen.css';

/** The line with all its states: `?players=9&seed=3&seconds=12`. */
const query = new URLSearchParams(location.search);
const count = Number(query.get('players') ?? 6);
const NAMES = ['Mara', 'Theo', 'Ines', 'Jo', 'Sam', 'Lin', 'Lea', 'Ole', 'Maximilian Berg'];

const players: Player[] = Array.from({ length: count }, (_, seat) => ({
  seat,
  name: NAMES[seat] ?? `Bot ${seat}`,
  isReady: false,
  isWaiting: false,
  points: 0,
  ...(seat < NAMES.length && { key: `key-${seat}` }),
}));
const state = huntGame.start({
  seats: players.map(({ seat }) => seat),
  seed: Number(query.get('seed') ?? 3),
});
const area = { x: 0.28, y: 0.05, width: 0.41, height: 0.6 };
const answers: Record<number, (label: string) => Answer> = {
  0: (text) => ({ text, score: 0.94, atMs: 5000, area }),
  1: () => ({ text: '', score: 0, atMs: 11_000 }),
  2: () => ({ text: 'bowl', score: 0.88, atMs: 6000, area }),
  3: (text) => ({ text, score: 0.7, atMs: 9000 }),
  4: (text) => ({ text, score: 0.97, atMs: 4000, area }),
};
const steps = Number(query.get('seconds') ?? 12) * 60;
for (let step = 0; step < steps; step += 1) {
  const label = state.hunt?.label ?? '';
  huntGame.step(
    state,
    (seat) => ({
      x: 0,
      y: 0,
      isPressed: false,
      ...(answers[seat] && { answer: answers[seat](label) }),
    }),
    huntGame.settings,
  );
}

const jpeg = new Uint8Array(await (await fetch(coffee)).arrayBuffer());
const { width, height } = await createImageBitmap(new Blob([jpeg]));
const photos = new Map<string, Photo>(
  [0, 1, 2, 4].map((seat) => [
    `key-${seat}`,
    { jpeg, width, height, atMs: state.hunt!.photos[seat]?.atMs ?? 0 },
  ]),
);
createApp(() =>
  h(HuntScene, {
    state,
    headline: huntGame.hud(state, String).headline,
    players,
    photos,
    startsAtMs: 0,
  }),
).mount('#app');
