import type { ModuleStatistics } from '@ubii/proto';
import { expect, it } from 'vitest';
import { LoadingPace, loadingOf } from './module-loading.ts';

const statistics = (loadedBytes: number, loadingSet = 'centernet-coco') =>
  ({
    moduleId: 'm1',
    moduleName: 'object-detection',
    loadingSet,
    loadedBytes,
    loadingBytes: 20_000_000,
  }) as ModuleStatistics;

it('reads from the statistics of a module what it loads [PM-94]', () => {
  expect(loadingOf(statistics(5_000_000))).toMatchObject({ set: 'centernet-coco', share: 0.25 });
  expect(loadingOf(statistics(0, ''))).toBeUndefined();
  expect(loadingOf(undefined)).toBeUndefined();
});

it('tells the time that is left by the pace so far, and begins again with each set', () => {
  const pace = new LoadingPace();
  expect(pace.with(loadingOf(statistics(0))!, 1000).leftMs).toBeUndefined();
  expect(pace.with(loadingOf(statistics(5_000_000))!, 2000).leftMs).toBe(3000);
  expect(pace.with(loadingOf(statistics(1_000_000, 'tfjs-wasm'))!, 3000).leftMs).toBeUndefined();
});
