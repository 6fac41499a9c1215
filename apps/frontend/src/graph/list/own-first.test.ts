import { fromJson, ModuleOrigin } from '@ubii/proto';
import { expect, it } from 'vitest';
import { addables } from '../canvas/addable.ts';
import { aGraphOf } from '../model/testing/small-graph.ts';
import { ownFirst } from './own-first.ts';

it('lists topics of this browser and modules written here before all others', () => {
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
  const found = addables(aGraphOf([]), sources, '', undefined);
  const names = ownFirst(found, 'me').map(({ text }) => text);
  expect(names.slice(0, 4)).toEqual(['/me/touch', 'me/orientation', 'my-radius', 'clock']);
  expect(names).toHaveLength(found.length);
});
