import { fromJson, ModuleOrigin } from '@ubii/proto';
import { expect, it } from 'vitest';
import { addables } from '../canvas/addable.ts';
import { aGraphOf } from '../model/testing/small-graph.ts';
import { ownFirst } from './own-first.ts';

const FOUND = (() => {
  const module = (name: string, origin: ModuleOrigin) =>
    fromJson('ubii.processing.ProcessingModule', { name, extension: { origin } });
  const sources = {
    modules: [
      module('clock', ModuleOrigin.MODULE_ORIGIN_BUILT_IN),
      module('my-radius', ModuleOrigin.MODULE_ORIGIN_STORED),
    ],
    topics: [
      { topic: '/other/touch', format: 'vector2' },
      { topic: '/me/touch', format: 'vector2' },
      { topic: 'me/orientation', format: 'vector3' },
    ],
  };
  return addables(aGraphOf([]), sources, '', undefined);
})();
const order = (hasModule: boolean) => ownFirst(FOUND, 'me', hasModule).map(({ text }) => text);

it('lists topics of this browser and modules written here before all others', () => {
  expect(order(true).slice(0, 4)).toEqual(['/me/touch', 'me/orientation', 'my-radius', 'clock']);
  expect(order(true)).toHaveLength(FOUND.length);
});

it('lists modules first in a session without one, as its first step asks for one', () => {
  expect(order(false).slice(0, 4)).toEqual(['my-radius', 'clock', '/me/touch', 'me/orientation']);
  expect(order(false)).toHaveLength(FOUND.length);
});
