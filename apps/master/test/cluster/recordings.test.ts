import { describe, expect, it } from 'vitest';
import { contentOf, start, stop } from '../recording-world.ts';
import { change, save, startRun } from '../study-world.ts';
import { clusterOf } from './cluster-world.ts';

describe('a recording at one master', () => {
  it('[CU-17] has what clients of the others publish, from the values that stand', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await b!.extension('publisher');
    publisher.publish('/stands', 'double', 1);
    await world.pass();
    const id = await start(a!);
    await world.pass();
    publisher.publish('/new', 'double', 2);
    await world.pass();
    await stop(a!, id);
    const { values } = await contentOf(a!, id);
    expect(values).toEqual([
      ['/stands', 1],
      ['/new', 2],
    ]);
  });

  it('[CU-17] asks for nothing but the topics that it selects', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await b!.extension('publisher');
    const id = await start(a!, { topics: ['/one'], patterns: ['/room/**'] });
    await world.pass();
    for (const topic of ['/one', '/room/1/heat', '/hall']) publisher.publish(topic, 'double', 1);
    await world.pass();
    expect(world.crossed()).toBe(2);
    await stop(a!, id);
    publisher.publish('/one', 'double', 2);
    await world.pass();
    expect(world.crossed()).toBe(2);
    const { values } = await contentOf(a!, id);
    expect(values).toEqual([
      ['/one', 1],
      ['/room/1/heat', 1],
    ]);
  });

  it('[CU-17] [ST-26] of a study does not begin with what stood at another master before the run', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await b!.extension('publisher');
    publisher.publish('/heart', 'double', 60);
    publisher.publish('/settings/light', 'double', 0.5);
    const { id } = await save(a!, { settingPatterns: ['/settings/**'] });
    await world.pass();
    const run = await startRun(a!, id, 'P02');
    // A page of this run gets the value of the participant before.
    const page = await a!.extension('page');
    await page.subscribe({ subscribeTopics: ['/heart'] });
    await world.pass();
    await change(a!, run.id, 'begin');
    await world.pass();
    publisher.publish('/heart', 'double', 71);
    await world.pass();
    const { blocks } = await change(a!, run.id, 'end');
    const { values } = await contentOf(a!, blocks[0]!.takes[0]!.recordingId);
    expect(values).toEqual([
      ['/settings/light', 0.5],
      ['/heart', 71],
    ]);
  });
});
