import { expect, test } from '../../fixtures/test.ts';
import { GathererPage, TouchedPhone } from '../../pages/gatherer-page.ts';

test('four phones come and go while it runs, and exactly those who touch near feel it', async ({
  room,
}) => {
  test.slow();
  const stage = new GathererPage((await room.atDesk('Stage')).page);
  await stage.open();
  await expect(stage.page.getByRole('heading', { name: 'No phones yet' })).toBeVisible();
  await stage.start();

  const join = async (name: string) => TouchedPhone.join(await room.withPhone(name));
  const anna = await join('Anna');
  await stage.expectPhones('Anna');
  const ben = await join('Ben');
  const cleo = await join('Cleo');
  const dora = await join('Dora');
  await stage.expectPhones('Anna', 'Ben', 'Cleo', 'Dora');

  // Whom the session tells to vibrate
  const program = await room.program('listener');
  const told = new Map<string, number>();
  const vibrations = program.subscribe({ glob: '/*/vibration_pattern' }, { format: 'double' });
  vibrations.onRecord(({ topic }) => {
    const id = topic.split('/')[1]!;
    told.set(id, (told.get(id) ?? 0) + 1);
  });
  await vibrations.ready;
  const [annaId, benId] = [await stage.idOf('Anna'), await stage.idOf('Ben')];

  await test.step('every finger is on the pad', async () => {
    await cleo.touch([0.9, 0.9], [0.7, 0.2]);
    await expect(stage.touches).toHaveCount(2);
    await expect(stage.phone('Cleo')).toContainText('2 fingers');
  });

  await test.step('two near ones vibrate or flash, are linked, and nobody else is', async () => {
    await anna.touch([0.3, 0.3]);
    await ben.touch([0.33, 0.32]);
    await expect(stage.pairs).toHaveCount(1);
    await expect(anna.flash).toBeVisible();
    await expect(ben.flash).toBeVisible();
    await expect(anna.page.getByText('Another finger is near')).toBeVisible();
    await expect(stage.phone('Anna')).toContainText('Near');
    // Longer than a touch counts that is not repeated: resting fingers go on feeling each other
    await expect.poll(() => told.get(annaId) ?? 0, { timeout: 20_000 }).toBeGreaterThan(30);
    expect(new Set(told.keys())).toEqual(new Set([annaId, benId]));
    await expect(cleo.flash).toHaveCount(0);
    await expect(stage.phone('Cleo')).not.toContainText('Near');
  });

  await test.step('somebody else who looks finds the same session', async () => {
    const other = new GathererPage((await room.atDesk('Balcony')).page);
    await other.open();
    await other.expectSession('Running');
    await expect(other.pairs).toHaveCount(1);
    const { elements } = await program.call('sessionRuntimeGetList');
    expect(elements).toHaveLength(1);
    await other.page.close();
  });

  await test.step('a phone that leaves disappears from the pad, and the other one is near none', async () => {
    await ben.page.close();
    await stage.expectPhones('Anna', 'Cleo', 'Dora');
    await expect(stage.pairs).toHaveCount(0);
    await expect(anna.page.getByText('Another finger is near')).toHaveCount(0);
    await expect(anna.flash).toHaveCount(0);
  });

  await test.step('how near is near is said on the page', async () => {
    await dora.touch([0.3, 0.55]);
    await expect(stage.touches).toHaveCount(4);
    await expect(stage.pairs).toHaveCount(0);
    await stage.distance.focus();
    await stage.page.keyboard.press('End');
    await expect(stage.pairs).toHaveCount(1);
    await expect(dora.flash).toBeVisible();
  });

  await test.step('stopped, nobody feels anything', async () => {
    await stage.stop();
    await expect(stage.pairs).toHaveCount(0);
    await expect(dora.page.getByText('Another finger is near')).toHaveCount(0);
    await expect(dora.flash).toHaveCount(0);
    await stage.start();
    await expect(stage.pairs).toHaveCount(1);
    await dora.lift();
    await expect(stage.pairs).toHaveCount(0);
    await expect(anna.page.getByText('Another finger is near')).toHaveCount(0);
  });

  await test.step('the session and the code are shown', async () => {
    await stage.page.getByRole('button', { name: 'Source code' }).click();
    await expect(stage.page.getByRole('region', { name: 'useGatherer.ts' })).toContainText(
      'useGatherer',
    );
    await stage.page.getByRole('radio', { name: 'Session' }).click();
    await expect(stage.page.getByRole('dialog')).toContainText('topicMux');
    await stage.page.keyboard.press('Escape');
    const opened = stage.page.waitForEvent('popup');
    await stage.page.getByRole('link', { name: 'Open session' }).click();
    const graph = await opened;
    await expect(graph).toHaveURL(/\/sessions\/[^/]+$/);
    // By its name: what stands on the node is cut in the middle when it is long
    const muxer = graph.getByRole('group', { name: 'Muxer touches of all phones' });
    await expect(muxer).toBeVisible();
  });
});
