// @vitest-environment happy-dom
import type { MasterChange } from '@ubii/client-web';
import { expect, it } from 'vitest';
import { createToasts } from '../ui/toasts/toasts.ts';
import { tellMoves } from './tell-moves.ts';

it('[CU-92] says where the page is now, the newest place only', () => {
  const toasts = createToasts();
  let move: (change: MasterChange) => void = () => undefined;
  tellMoves({ onMaster: (fn) => ((move = fn), () => undefined) }, toasts);
  move({ previousUrl: 'http://10.0.0.5:8080', url: 'http://10.0.0.6:8080' });
  move({ previousUrl: 'http://10.0.0.6:8080', url: 'https://m3.example' });
  expect(toasts.list.value.map(({ text }) => text)).toEqual([
    'The master was lost. Moved to m3.example.',
  ]);
});
