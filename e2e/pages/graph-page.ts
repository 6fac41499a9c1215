import { expect, type Locator, type Page } from '@playwright/test';

/** On the page, pixels. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** The graph of a session, with a mouse. */
export class GraphPage {
  readonly page: Page;
  readonly canvas: Locator;
  readonly palette: Locator;
  readonly inspector: Locator;
  readonly refusal: Locator;
  readonly life: Locator;
  /** The name of the session in the top bar. */
  readonly title: Locator;
  /** Other users who have the session open. */
  readonly others: Locator;
  readonly importDialog: Locator;
  readonly menu: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.canvas = page.getByRole('application', { name: 'Graph of the session' });
    this.palette = page.getByRole('complementary', { name: 'Palette' });
    this.inspector = page.getByRole('complementary', { name: 'Inspector' });
    this.refusal = page.getByRole('alertdialog', { name: 'This wire is not possible' });
    this.menu = page.getByRole('menu', { name: / actions$/ });
    this.life = page.getByRole('toolbar', { name: 'Session controls' });
    this.title = page.getByRole('button', { name: /, rename$/ });
    this.others = page.getByRole('group', { name: 'Other users' });
    this.importDialog = page.getByRole('dialog', { name: /Import|No session/ });
  }

  async open(sessionId: string): Promise<void> {
    // As in a browser in which it was left open: the graph is fitted into the room beside it.
    await this.page.addInitScript(() => {
      // Not in the empty page before, which has no storage.
      if (origin !== 'null') localStorage.setItem('ubii.graph.palette', 'true');
    });
    await this.page.goto(`/sessions/${sessionId}`);
    await expect(this.canvas).toBeVisible();
  }

  /** Keeps topics and modules open beside the canvas, unless they are: this browser remembers it. */
  async openPalette(): Promise<void> {
    const add = this.page.getByRole('button', { name: 'Add', exact: true });
    await expect(add).toBeVisible();
    if (!(await this.palette.isVisible())) {
      await add.click();
      await this.page.getByRole('button', { name: 'Keep open at the side' }).click();
    }
    await expect(this.palette).toBeVisible();
  }

  /** Focuses a node, and shows all nodes in the room that its inspector leaves. */
  async fitBesideInspector(node: string): Promise<void> {
    await this.node(node).focus();
    await expect(this.inspector).toBeVisible();
    await this.page.keyboard.press('Home');
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }

  /** Chooses what is done with the graph as a whole. */
  async chooseTool(name: string): Promise<void> {
    await this.page.getByRole('button', { name: 'More graph tools' }).click();
    await this.page.getByRole('menuitem', { name }).click();
  }

  /** Undoes all that was done since the page was opened, selects nothing, and shows all nodes as at first. */
  async startAgain(): Promise<void> {
    const { keyboard } = this.page;
    const undo = this.page.getByRole('button', { name: /^Undo: / });
    await this.canvas.focus();
    while (await undo.isVisible()) await keyboard.press('Control+z');
    await keyboard.press('Escape');
    await keyboard.press('Home');
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }

  /** Chooses what is done with the session as a whole. */
  async choose(action: string): Promise<void> {
    await this.page.getByRole('button', { name: 'Session menu' }).click();
    await this.page.getByRole('menuitem', { name: action }).click();
  }

  async rename(name: string): Promise<void> {
    await this.title.click();
    const field = this.page.getByRole('textbox', { name: 'Name of the session' });
    await field.fill(name);
    await field.press('Enter');
  }

  /** Writes the description of the session, in its details. */
  async describe(text: string): Promise<void> {
    await this.choose('Details…');
    const dialog = this.page.getByRole('dialog');
    await dialog.getByLabel('Description').fill(text);
    await dialog.getByRole('button', { name: 'Done' }).click();
  }

  /**
   * Drops a file on the canvas, as from the desktop of the system.
   * @param spaces after its text, made in the page: to send them there takes seconds
   */
  async dropFile(name: string, text: string, spaces = 0): Promise<void> {
    const dataTransfer = await this.page.evaluateHandle(
      ([fileName, content, count]) => {
        const transfer = new DataTransfer();
        const parts = [content, ' '.repeat(count)];
        transfer.items.add(new File(parts, fileName, { type: 'application/json' }));
        return transfer;
      },
      [name, text, spaces] as const,
    );
    await this.canvas.dispatchEvent('dragenter', { dataTransfer });
    await expect(this.page.getByText('Drop to import')).toBeVisible();
    await this.canvas.dispatchEvent('drop', { dataTransfer });
  }

  /** `Module low-pass`, `Topic /a/b`. */
  node(label: string): Locator {
    return this.canvas.getByRole('group', { name: label, exact: true });
  }

  /** A socket by the words before its format: `Input value`. */
  socket(node: string, name: string): Locator {
    return this.node(node).getByRole('button', { name: new RegExp(`^${name}, `) });
  }

  /** In the context menu, or in a menu of it. */
  menuItem(text: string): Locator {
    return this.page.getByRole('menuitem', { name: text, exact: true });
  }

  /** Presses a mouse button on the middle of the only wire, or of one of them. */
  async pointAtWire(button: 'left' | 'right', wire = 0): Promise<void> {
    const path = this.canvas.locator('[data-wire] .hit').nth(wire);
    const { x, y } = await path.evaluate((element: SVGPathElement) => {
      // A quarter of the way: the middle holds what flows.
      const point = element.getPointAtLength(element.getTotalLength() * 0.3);
      const on = point.matrixTransform(element.getScreenCTM() ?? undefined);
      return { x: on.x, y: on.y };
    });
    await this.page.mouse.click(x, y, { button });
  }

  paletteTopic(topic: string): Locator {
    return this.palette.locator(`[data-palette-topic="${topic}"]`);
  }

  paletteModule(name: string): Locator {
    return this.palette.locator(`[data-palette-module="${name}"]`);
  }

  palettePart(name: string): Locator {
    return this.palette.locator(`[data-palette-part="${name}"]`);
  }

  /** A node that runs modules. */
  paletteHost(name: string): Locator {
    return this.palette.locator(`[data-palette-host="${name}"]`);
  }

  /** The field in the row of an input that nothing is wired to. */
  value(node: string, input: string): Locator {
    return this.node(node).getByLabel(`Value of ${input}`, { exact: true });
  }

  /** The mark that something is wrong with a node, or with one of its ports. */
  problems(node: string): Locator {
    return this.node(node).getByRole('button', { name: /^\d+ problems?: / });
  }

  /** Card with the values at the hovered wire or socket. */
  get passing(): Locator {
    return this.page.locator('[data-hover-card]');
  }

  /** Drags with a real mouse, in steps, as a hand does. */
  async drag(from: Locator, to: Place): Promise<void> {
    const { mouse } = this.page;
    // A list that is being filtered makes its rows again
    await expect(() => from.scrollIntoViewIfNeeded({ timeout: 1000 })).toPass();
    const start = await middleOf(from);
    await mouse.move(start.x, start.y);
    await mouse.down();
    await mouse.move(start.x + 12, start.y + 8);
    await mouse.move((start.x + to.x) / 2, (start.y + to.y) / 2, { steps: 4 });
    await mouse.move(to.x, to.y, { steps: 4 });
    await mouse.up();
  }

  async dragTo(from: Locator, to: Locator): Promise<void> {
    await this.drag(from, await middleOf(to));
  }

  /** Goes there with the button held down, in steps, as a hand does. */
  async pull(from: Place, to: Place): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
    await mouse.move(to.x, to.y, { steps: 4 });
  }

  async pullBy(from: Place, x: number, y: number): Promise<void> {
    await this.pull(from, { x: from.x + x, y: from.y + y });
  }

  /** Position for dragging a node: its header, or the title of a frame. */
  async grip(label: string): Promise<Place> {
    const { x, y } = await this.box(label);
    return { x: x + 40, y: y + 14 };
  }

  async box(label: string): Promise<Place & { width: number; height: number }> {
    return await boxOf(this.node(label));
  }

  /** The middle between two sockets: where a wire between them passes. */
  async between(from: Locator, to: Locator): Promise<Place> {
    const [a, b] = [await middleOf(from), await middleOf(to)];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  }

  /** The points wires are led through. */
  get points(): Locator {
    return this.canvas.locator('[data-wire-point]');
  }

  async middleOf(locator: Locator): Promise<Place> {
    return await middleOf(locator);
  }

  /** A place on the canvas, as a share of its width and height. */
  async spot(x: number, y: number): Promise<Place> {
    const box = await boxOf(this.canvas);
    return { x: box.x + box.width * x, y: box.y + box.height * y };
  }
}

/** The box of what is seen, also when a list is drawn again at that moment. */
async function boxOf(locator: Locator) {
  for (;;) {
    await locator.waitFor();
    const box = await locator.boundingBox();
    if (box !== null) return box;
  }
}

async function middleOf(locator: Locator): Promise<Place> {
  const { x, y, width, height } = await boxOf(locator);
  return { x: x + width / 2, y: y + height / 2 };
}
