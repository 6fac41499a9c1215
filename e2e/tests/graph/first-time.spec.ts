import type { Locator, Page } from '@playwright/test';
import { expect, test, type Room } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Fingers, middleOf } from '../../pages/touch.ts';

const TABLET = { viewport: { width: 1024, height: 768 }, hasTouch: true, isMobile: true } as const;
const MODULE = 'one-euro-filter-vector2';

/** Somebody's phone, whose pointer is a topic as soon as it has touched the pad. */
async function aPhone(room: Room): Promise<Locator> {
  const { page } = await room.withPhone('Ines');
  await page.goto('/examples/mouse-pointer');
  const pad = page.getByRole('application', { name: 'Pointer pad' });
  await pad.tap({ position: { x: 40, y: 60 } });
  return pad;
}

async function anEmptyEditor(page: Page): Promise<GraphPage> {
  await page.goto('/sessions/new');
  const graph = new GraphPage({ page });
  await expect(page.getByRole('region', { name: 'Getting started' })).toBeVisible();
  await graph.openPalette();
  return graph;
}

/** The last of them: a topic without a record is in the tree, too, while a page subscribes to it. */
const pointerOf = (graph: GraphPage): Locator =>
  graph.palette.locator('[data-palette-topic$="/mouse_client_position"]').last();
const module = `Module ${MODULE}`;

/** The smoothed position is on the second topic, and its wire is told how often it comes. */
async function seesItLive(graph: GraphPage, pad: Locator): Promise<void> {
  const smoothed = graph.node('Topic /Session/smoothed');
  await expect(async () => {
    await pad.tap({ position: { x: 200, y: 200 } });
    await pad.tap({ position: { x: 60, y: 300 } });
    await expect(smoothed).toContainText(/0\.\d/, { timeout: 2_000 });
    await expect(graph.canvas.locator('[data-wire-chip]').last()).toContainText('Hz', {
      timeout: 2_000,
    });
  }).toPass();
}

test('the pointer of a phone is smoothed, from an empty editor and by an example', async ({
  room,
}) => {
  const pad = await aPhone(room);
  const { page } = await room.atDesk('Anna');
  await test.step('at a desk, a pointer is smoothed onto a second topic from an empty editor', async () => {
    const graph = await anEmptyEditor(page);

    await test.step('a click on the topic offers to add it', async () => {
      await pointerOf(graph).click();
      await page.getByRole('button', { name: 'Add to graph: mouse_client_position' }).click();
      await expect(graph.canvas.getByRole('group', { name: /^Topic / })).toBeVisible();
      await expect(page.getByText('Next: drag a module in.')).toBeVisible();
    });

    await test.step('the module is found by what it does', async () => {
      await graph.palette.getByLabel('Filter topics and modules').fill('smooth');
      await graph.drag(graph.paletteModule(MODULE), await graph.spot(0.7, 0.2));
      await expect(graph.node(module)).toBeVisible();
    });

    await test.step('a wire leads from the topic to its input', async () => {
      await graph.dragTo(
        graph.canvas.getByRole('button', { name: /^Output \/.*mouse_client_position, / }),
        graph.socket(module, 'Input value'),
      );
      await expect(graph.socket(module, 'Input value')).toHaveAccessibleName(/1 connected/);
    });

    await test.step('nothing covers what is pulled next', async () => {
      await expect(graph.passing).toBeHidden();
      // Over what floats there, which lets a wire through.
      await graph.drag(graph.socket(module, 'Output smoothed'), await graph.spot(0.94, 0.8));
      const search = page.getByRole('combobox', { name: 'Connect to a new node' });
      await expect(search).toBeVisible();
      await search.press('Enter');
      await expect(graph.socket(module, 'Output smoothed')).toHaveAccessibleName(/1 connected/);
    });

    await test.step('it is started, and seen', async () => {
      await expect(page.getByText('Next: press Save and start.')).toBeVisible();
      await graph.life.getByRole('button', { name: 'Start' }).click();
      await expect(graph.life).toContainText('Running');
      await seesItLive(graph, pad);
      await graph.canvas.locator('[data-wire-chip]').last().hover();
      await expect(async () => {
        await pad.tap({ position: { x: 120, y: 120 } });
        await expect(graph.passing).toContainText(/0\.\d+, 0\.\d+/, { timeout: 2_000 });
      }).toPass();
    });

    await test.step('the palette shows what another module would give, and favourites', async () => {
      await graph.socket(module, 'Output smoothed').focus();
      await page.keyboard.press('l');
      const palette = page.getByRole('dialog', { name: /^Connect / });
      await page.keyboard.type('mirror-pointer');
      await expect(async () => {
        await pad.tap({ position: { x: 80, y: 90 } });
        await expect(palette.getByRole('figure')).toContainText(/mirrored0\.\d+, 0\.\d+/, {
          timeout: 2_000,
        });
      }).toPass();
      await page.keyboard.press('Control+f');
      await expect(palette.getByRole('option', { selected: true })).toContainText('favourite');
      await page.keyboard.press('Escape');
      await expect(palette).toBeHidden();
    });
  });

  await test.step('an example runs with the finger of a phone, one click after it was chosen', async () => {
    const graph = new GraphPage({ page });
    await page.goto('/sessions/new');
    const begin = page.getByRole('region', { name: 'Getting started' });
    await expect(async () => {
      await pad.tap({ position: { x: 40, y: 60 } });
      await expect(begin).toContainText('Uses the pointer of Ines.', { timeout: 1000 });
    }).toPass();
    await begin.getByRole('button', { name: /^Smooth a pointer/ }).click();
    await expect(graph.title).toHaveText('Smooth a pointer');
    await graph.life.getByRole('button', { name: 'Start' }).click();
    await expect(graph.life).toContainText('Running');
    await expect(async () => {
      await pad.tap({ position: { x: 200, y: 200 } });
      await pad.tap({ position: { x: 60, y: 300 } });
      await expect(graph.node('Topic /examples/smooth-pointer/smoothed')).toContainText(/0\.\d/, {
        timeout: 2_000,
      });
    }).toPass();

    await test.step('it was one step', async () => {
      await graph.canvas.focus();
      await page.keyboard.press('Control+z');
      await expect(begin).toBeVisible();
    });
  });
});

test('with fingers on a tablet, a pointer is smoothed onto a second topic @smoke', async ({
  room,
}) => {
  const pad = await aPhone(room);
  const { page } = await room.atDesk('Anna', TABLET);
  const fingers = await Fingers.on(page);
  const graph = await anEmptyEditor(page);

  await test.step('a topic is dragged from the palette', async () => {
    const row = pointerOf(graph);
    // The palette draws its rows again while topics of the phone appear.
    await expect(() => row.scrollIntoViewIfNeeded()).toPass();
    await fingers.drag(await middleOf(row), await graph.spot(0.2, 0.3));
    await expect(graph.canvas.getByRole('group', { name: /^Topic / })).toBeVisible();
  });

  await test.step('a tap on a module offers to add it', async () => {
    const row = graph.paletteModule(MODULE);
    await row.scrollIntoViewIfNeeded();
    await row.tap();
    await page.getByRole('button', { name: `Add to graph: ${MODULE}` }).tap();
    await expect(graph.node(module)).toBeVisible();
  });

  await test.step('wires are pulled to its input, and from its output to nothing', async () => {
    const output = graph.canvas.getByRole('button', {
      name: /^Output \/.*mouse_client_position, /,
    });
    const input = graph.socket(module, 'Input value');
    await fingers.drag(await middleOf(output), await middleOf(input));
    await expect(input).toHaveAccessibleName(/1 connected/);
    const smoothed = graph.socket(module, 'Output smoothed');
    await fingers.drag(await middleOf(smoothed), await graph.spot(0.85, 0.85));
    // Browsers take a tap some milliseconds after a drag for its end; people are slower.
    await expect(async () => {
      await page.getByRole('option', { name: /^New topic/ }).tap({ timeout: 2_000 });
      await expect(smoothed).toHaveAccessibleName(/1 connected/, { timeout: 2_000 });
    }).toPass();
  });

  await test.step('it is started, and seen; a finger held on the wire shows what passes', async () => {
    await graph.life.getByRole('button', { name: 'Start' }).tap();
    await expect(graph.life).toContainText('Running');
    await seesItLive(graph, pad);
    const chip = graph.canvas.locator('[data-wire-chip]').last();
    await fingers.hold(await middleOf(chip), () => expect(graph.menu).toBeVisible());
    await expect(graph.menu).toContainText('/Session/smoothed');
    await expect(async () => {
      await pad.tap({ position: { x: 120, y: 120 } });
      await expect(graph.menu).toContainText(/0\.\d+, 0\.\d+/, { timeout: 2_000 });
    }).toPass();
  });
});

test('an example that is started from the list of sessions takes the pointer of this browser', async ({
  room,
}) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/sessions');
  await page.getByRole('button', { name: 'Start Smooth a pointer' }).click();
  const graph = new GraphPage({ page });
  await expect(async () => {
    await page.mouse.move(500, 300);
    await page.mouse.move(700, 400);
    await expect(graph.node('Topic /examples/smooth-pointer/smoothed')).toContainText(/0\.\d/, {
      timeout: 2_000,
    });
  }).toPass();

  await test.step('what the editor tells other editors is not among the topics', async () => {
    await page.getByRole('link', { name: 'Topics', exact: true }).first().click();
    await expect(page.getByRole('row', { name: /smoothed/ })).toBeVisible();
    await expect(page.getByText('presence')).toHaveCount(0);
  });
});
