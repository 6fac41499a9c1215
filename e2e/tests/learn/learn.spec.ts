import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Shell } from '../../pages/shell.ts';

const next = (page: Page): Locator =>
  page.getByRole('button', { name: /^(Next: |Finish the lesson)/ });
const checks = (page: Page): Locator => page.getByRole('list', { name: 'Checks' });

/** Moves the mouse in the editor until all checks of the step have passed, then goes on. */
async function moveUntilPassed(page: Page): Promise<void> {
  const box = await page.getByRole('region', { name: /^Editor of the lesson/ }).boundingBox();
  if (box === null) throw new Error('The editor is not visible.');
  await expect(async () => {
    for (const share of [0.3, 0.45, 0.6, 0.4]) {
      await page.mouse.move(box.x + box.width * share, box.y + box.height * 0.2, { steps: 6 });
    }
    await expect(next(page)).not.toHaveAttribute('aria-disabled', 'true', { timeout: 700 });
  }).toPass();
  await next(page).click();
  // Away from the button: its tooltip covers the buttons beside it.
  await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.2);
}

async function waitAndGoOn(page: Page): Promise<void> {
  await expect(next(page)).not.toHaveAttribute('aria-disabled', 'true', { timeout: 20_000 });
  await next(page).click();
}

test('a phone in the page is touched and its values are read', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/learn/see-a-phone');
  await expect(next(page)).toHaveAttribute('aria-disabled', 'true');
  await page.getByRole('button', { name: 'Open a phone in this page' }).click();
  await waitAndGoOn(page);
  const pad = page.frameLocator('iframe').getByRole('application', { name: 'Touch pad' });
  const box = await pad.boundingBox();
  if (box === null) throw new Error('The pad is not visible.');
  const at = (x: number, y: number) =>
    page.mouse.move(box.x + box.width * x, box.y + box.height * y, { steps: 8 });
  const circle = async (): Promise<void> => {
    await at(0.5, 0.5);
    await page.mouse.down();
    for (const [x, y] of [
      [0.9, 0.5],
      [0.5, 0.9],
      [0.1, 0.5],
      [0.5, 0.1],
    ] as const) {
      await at(x, y);
    }
    await page.mouse.up();
  };
  for (let step = 0; step < 2; step += 1) {
    await expect(async () => {
      await circle();
      await expect(next(page)).not.toHaveAttribute('aria-disabled', 'true', { timeout: 700 });
    }).toPass();
    await next(page).click();
  }
  await expect(checks(page)).toContainText('value');
  await waitAndGoOn(page);
  await expect(page.getByText('Lesson done.')).toBeVisible();
  await page.reload();
  await expect(
    page.getByRole('navigation', { name: 'Contents' }).getByRole('link', { name: /, done/ }),
  ).toContainText('See a phone live');

  await test.step('a phone that is there already needs no other', async () => {
    await page.getByRole('button', { name: 'Close the last phone' }).click();
    const tom = await room.withPhone('Tom');
    await tom.page.goto('/devices/smart-device');
    await expect(page.getByText('Tom is connected. Use that phone')).toBeVisible();
  });
});

test('two topics are wired with a mouse, and the answer can be undone', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  const graph = new GraphPage({ page });
  const module = 'Module mirror-pointer';
  await page.goto('/learn/wire-two-topics');
  await expect(graph.node(module)).toBeVisible();
  await moveUntilPassed(page);

  await graph.dragTo(
    graph.canvas.getByRole('button', { name: /^Output \/.*mouse_client_position, / }),
    graph.socket(module, 'Input pointer'),
  );
  await expect(graph.socket(module, 'Input pointer')).toHaveAccessibleName(/1 connected/);
  await graph.life.getByRole('button', { name: 'Save and start' }).click();
  await moveUntilPassed(page);

  await page.getByRole('button', { name: 'Show answer' }).click();
  await expect(graph.socket(module, 'Output mirrored')).toHaveAccessibleName(/1 connected/);
  await page.getByRole('button', { name: 'Undo', exact: true }).last().click();
  await expect(graph.socket(module, 'Output mirrored')).not.toHaveAccessibleName(/1 connected/);
  // The answer goes into the session that comes, however long the old one takes to go.
  await page.route('**/services*/**', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 300));
    await route.continue();
  });
  await page.getByRole('button', { name: 'Reset', exact: true }).click();
  await page.getByRole('button', { name: 'Show answer' }).click();
  await page.unrouteAll({ behavior: 'ignoreErrors' });
  await moveUntilPassed(page);

  await graph.value(module, 'mirrorX').click();
  await moveUntilPassed(page);
  await expect(page.getByText('Lesson done.')).toBeVisible();

  await test.step('its session is removed with the lesson, unless it is kept', async () => {
    await new Shell(page).go('Home');
    await expect(page.getByText('The session of the lesson was removed')).toBeVisible();
    await page.getByRole('button', { name: 'Keep it' }).click();
    await expect(graph.node(module)).toBeVisible();
    await expect(graph.life).toContainText('Running');
  });
});

test('fingers of two phones in the page are counted by one session', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  const graph = new GraphPage({ page });
  await page.goto('/learn/many-phones');
  await expect(graph.node('Module touch-proximity')).toBeVisible();
  for (const label of [/^Muxer/, /^Module/, /^Topic/]) {
    await expect(graph.canvas.getByRole('group', { name: label })).toBeInViewport({ ratio: 0.99 });
  }
  const touchBoth = async (): Promise<void> => {
    for (const phone of ['Phone 1', 'Phone 2']) {
      await page.getByRole('radio', { name: phone }).click();
      const frame = page.frameLocator(`iframe[title="${phone}"]`);
      await frame.getByRole('application', { name: 'Touch pad' }).click();
    }
  };
  await page.getByRole('button', { name: 'Open a phone in this page' }).click();
  await page.getByRole('button', { name: 'Open another phone in this page' }).click();
  await waitAndGoOn(page);
  await touchBoth();
  await waitAndGoOn(page);
  await graph.life.getByRole('button', { name: 'Start', exact: true }).click();
  await waitAndGoOn(page);
  // The first touch is over soon: on a busy machine, before the other one.
  await expect(async () => {
    await touchBoth();
    await expect(next(page)).not.toHaveAttribute('aria-disabled', 'true', { timeout: 700 });
  }).toPass();
  await next(page).click();
  await expect(page.getByText('Lesson done.')).toBeVisible();
});

test('lessons about modules, programs and services are done', async ({ room }) => {
  const { page } = await room.atDesk('Anna');

  await test.step('a module is run, fed, written and put into a session', async () => {
    await page.goto('/learn/first-module');
    const tryIt = page.getByRole('region', { name: 'Try it' });
    await tryIt.getByRole('button', { name: 'Run', exact: true }).click();
    await waitAndGoOn(page);
    await tryIt.getByRole('radio', { name: 'Topic' }).click();
    await tryIt.getByRole('button', { name: /mouse_client_position/ }).click();
    await moveUntilPassed(page);
    for (let step = 0; step < 2; step += 1) {
      await page.getByRole('button', { name: 'Show answer' }).click();
      await waitAndGoOn(page);
    }
    await page.getByRole('button', { name: 'Run in a session' }).click();
    await moveUntilPassed(page);
    await expect(page.getByText('Lesson done.')).toBeVisible();
  });

  await test.step('a program of the client library is run, answers, and leaves', async () => {
    await page.goto('/learn/own-program');
    await page.getByText('In this page', { exact: true }).click();
    await page.getByRole('button', { name: 'Run in this page' }).click();
    await expect(page.getByRole('list', { name: 'Output of the program' })).toContainText(
      'connected as first program',
    );
    await waitAndGoOn(page);
    await waitAndGoOn(page);
    await page.getByRole('switch', { name: /^Lamp/ }).click();
    await waitAndGoOn(page);
    await page.getByRole('button', { name: 'Stop', exact: true }).click();
    await waitAndGoOn(page);
    await expect(page.getByText('Lesson done.')).toBeVisible();
  });

  await test.step('services reply and refuse', async () => {
    await page.goto('/learn/call-a-service');
    const call = page.getByRole('button', { name: 'Call', exact: true });
    await call.click();
    await waitAndGoOn(page);
    await page.getByRole('button', { name: 'topic_list' }).click();
    await call.click();
    await waitAndGoOn(page);
    await page.getByRole('button', { name: 'Show answer' }).click();
    await expect(checks(page)).toContainText('Anna');
    await waitAndGoOn(page);
    await page.getByRole('button', { name: 'session/runtime/stop' }).click();
    await page.getByRole('textbox', { name: 'id', exact: true }).fill('nothing');
    await call.click();
    await expect(checks(page)).toContainText('not_found');
    await waitAndGoOn(page);
    await expect(page.getByText('Lesson done.')).toBeVisible();
  });

  await test.step('a question finds the reference, and lesson and editor are tabs on a phone', async () => {
    const phone = (await room.withPhone('Ines')).page;
    await phone.goto('/learn');
    await phone.getByRole('searchbox', { name: 'Ask or search' }).fill('what is vector2');
    await phone.getByRole('link', { name: /^vector2\s*Data formats/ }).click();
    await expect(phone.getByRole('heading', { level: 1 })).toHaveText('Data formats');
    await expect(phone.locator('#vector2')).toContainText('Two numbers.');
    await phone.goto('/learn/call-a-service');
    await expect(phone.getByRole('heading', { level: 1 })).toBeVisible();
    await expect(phone.getByRole('button', { name: 'Call', exact: true })).toBeHidden();
    await phone.getByRole('radio', { name: 'Editor' }).click();
    await phone.getByRole('button', { name: 'Call', exact: true }).click();
    await phone.getByRole('radio', { name: 'Lesson' }).click();
    await waitAndGoOn(phone);
  });
});
