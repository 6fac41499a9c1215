import type { MasterEndpoints } from '@ubii/harness';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { PerformancePage } from '../../pages/performance-page.ts';
import { Shell } from '../../pages/shell.ts';

/** Objects of performance tests on the master: names of clients and sessions, and topics. */
async function leftOn(endpoints: MasterEndpoints): Promise<string[]> {
  const { clientList } = await callService(endpoints, { topic: '/services/client/get_list' });
  const { sessionList } = await callService(endpoints, {
    topic: '/services/session/runtime/get_list',
  });
  const { stringList } = await callService(endpoints, { topic: '/services/topic_list' });
  const clients = clientList!.elements
    .map(({ name }) => name)
    .filter((name) => /test( \d+)?$/.test(name));
  return [
    ...clients.map((name) => `client ${name}`),
    ...sessionList!.elements.map(({ name }) => name),
    ...(stringList?.elements ?? []).filter((topic) => topic.includes('/performance/')),
  ];
}

/** Runs so long that they are certainly still under way. */
const LONG: readonly (readonly [
  place: string,
  title: RegExp,
  fields: Readonly<Record<string, string>>,
])[] = [
  [
    'load',
    /^Message load/,
    { 'Lowest rate': '20', 'Highest rate': '40', 'Duration of a step': '60', Clients: '2' },
  ],
  ['session-speed', /^Session speed/, { Duration: '300', Modules: '2' }],
  ['screen', /^Topic to screen/, { Duration: '300' }],
];

test('a run that is stopped leaves nothing behind but what was measured', async ({
  master,
  room,
}) => {
  const page = new PerformancePage(await room.atDesk('Anna'));
  const placeOf = (title: RegExp) => page.places.getByRole('link', { name: title });
  await page.open();
  await page.fill({ Rate: '50', 'Duration of each': '300' });
  await page.begin();
  await expect.poll(() => leftOn(master.endpoints)).not.toEqual([]);

  await test.step('a run goes on while other tests are looked at, and no second one starts', async () => {
    await placeOf(/^Topic to screen/).click();
    await expect(page.start).toHaveAttribute('aria-disabled', 'true');
    await placeOf(/^Round trip/).click();
  });

  await test.step('what was measured until a run was stopped is kept, and says so', async () => {
    await expect.poll(() => page.figure('immediate.returned').isVisible()).toBe(true);
    await page.stop.click();
    await expect(page.start).not.toHaveAttribute('aria-disabled', 'true');
    await expect(
      page.page.getByText('Stopped early: the result covers the time until then'),
    ).toBeVisible();
  });

  await test.step('a run that is stopped leaves nothing behind: round-trip', () =>
    expect.poll(() => leftOn(master.endpoints)).toEqual([]));

  for (const [place, title, fields] of LONG) {
    await test.step(`a run that is stopped leaves nothing behind: ${place}`, async () => {
      await placeOf(title).click();
      await page.fill(fields);
      await page.begin();
      await expect.poll(() => leftOn(master.endpoints)).not.toEqual([]);
      await page.stop.click();
      await expect(page.start).toBeVisible();
      await expect.poll(() => leftOn(master.endpoints)).toEqual([]);
    });
  }
});

test('a session of a test ends with its page, however the page is left', async ({
  master,
  room,
}) => {
  const anna = await room.atDesk('Anna');
  const page = new PerformancePage(anna);
  const running = async (): Promise<void> => {
    await page.fill({ Duration: '300', Modules: '2' });
    await page.begin();
    await expect.poll(() => leftOn(master.endpoints)).toContain('Session speed test');
  };

  await test.step('to another page of the program', async () => {
    await page.open('session-speed');
    await running();
    await new Shell(anna.page).go('Home');
    await expect.poll(() => leftOn(master.endpoints)).toEqual([]);
  });
  await test.step('by a reload', async () => {
    await page.open('session-speed');
    await running();
    await anna.page.reload();
    await expect.poll(() => leftOn(master.endpoints)).toEqual([]);
  });
  await test.step('by closing it', async () => {
    await running();
    await anna.page.close({ runBeforeUnload: false });
    // Clients of a closed page are away for a while, as its own is
    await expect.poll(() => leftOn(master.endpoints)).not.toContain('Session speed test');
  });
});

test('a run ends when the master goes, and what it measured is kept', async ({ master, room }) => {
  const anna = await room.atDesk('Anna');
  const page = new PerformancePage(anna);
  await page.open();
  await page.fill({ Rate: '50', 'Duration of each': '300' });
  await page.begin();
  await expect.poll(() => page.figure('immediate.returned').isVisible()).toBe(true);
  anna.watch.expect(/net::ERR_/, /WebSocket connection to .* failed/, /Failed to load resource/);
  await master.stop();
  await expect(
    page.page.getByText('Connection lost: the result covers the time until then'),
  ).toBeVisible();
  await expect(page.start).toHaveAttribute('aria-disabled', 'true');
  await master.restart();
  await expect(page.start).not.toHaveAttribute('aria-disabled', 'true', { timeout: 60_000 });
  await expect.poll(() => leftOn(master.endpoints)).toEqual([]);
});
