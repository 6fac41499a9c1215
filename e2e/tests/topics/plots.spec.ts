import { readFile } from 'node:fs/promises';
import { expect, test } from '../../fixtures/test.ts';
import { PlotPage } from '../../pages/plot-page.ts';

test('a plot draws, hides and follows lines', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/arm', 'vector2', { x: 0.25, y: 0.5 });
  robot.publish('/lab/heel', 'double', 2);
  robot.publish('/lab/leg/pose', 'pose3D', { position: { x: 7.5, y: 0, z: 0 } });
  const plot = new PlotPage((await room.atDesk()).page);
  await plot.open('/lab/arm');
  await expect(plot.line('x')).toContainText('0.25');
  await expect(plot.line('y')).toBeVisible();

  await test.step('a line is hidden, shown as its change per second, and joined by another topic', async () => {
    await plot.line('y').click();
    await expect(plot.line('y')).toHaveAttribute('aria-pressed', 'false');
    await expect(plot.plot).toHaveAccessibleName(/^Plot of x over/);

    await plot.add('/lab/leg/pose', 'position.x');
    await expect(plot.legend.getByRole('listitem')).toHaveCount(3);
    await expect(plot.line('pose x')).toContainText('7.5');

    await plot.chooseFor('pose x', 'Change per second');
    await expect(plot.legend.getByText('′')).toBeVisible();
    await plot.choose('Reset lines');
    await expect(plot.legend.getByRole('listitem')).toHaveCount(2);
  });

  await test.step('a plot is looked at closer and moved with keys, and follows again', async () => {
    let angle = 0;
    const beat = setInterval(() => {
      angle += 0.1;
      robot.publish('/lab/arm', 'vector2', { x: Math.sin(angle), y: Math.cos(angle) });
    }, 50);
    await expect(plot.plot).toHaveAccessibleName(/^Plot of x, y over 10 s/);
    await plot.plot.focus();
    await plot.page.keyboard.press('+');
    await expect(plot.plot).toHaveAccessibleName(/over 7\.14 s/);
    await plot.page.keyboard.press('Shift+ArrowLeft');
    const back = plot.page.getByRole('button', { name: 'Follow the newest' });
    await expect(back).toBeVisible();
    await back.click();
    await expect(back).toBeHidden();

    // A stretch drawn with the mouse fills the plot.
    const box = (await plot.plot.boundingBox())!;
    const y = box.y + box.height / 2;
    await plot.page.mouse.move(box.x + box.width * 0.5, y);
    await plot.page.mouse.down();
    await plot.page.mouse.move(box.x + box.width * 0.6, y, { steps: 4 });
    await plot.page.mouse.up();
    await expect(back).toBeVisible();
    await expect(plot.plot).toHaveAccessibleName(/over (\d{3} ms|[01](\.\d+)? s)/);
    await plot.page.mouse.wheel(0, 300);
    await expect(plot.plot).not.toHaveAccessibleName(/over (\d{3} ms|0\.\d+ s)/);
    clearInterval(beat);
  });

  await test.step('a topic dragged onto a plot is drawn in it', async () => {
    const heel = plot.page.getByRole('rowheader', { name: 'heel' });
    await expect(heel).toBeVisible();
    await heel.hover();
    await plot.page.mouse.down();
    await plot.plot.hover();
    await plot.plot.hover({ position: { x: 200, y: 100 } });
    await plot.page.mouse.up();
    await expect(plot.legend.getByRole('listitem')).toHaveCount(3);
    await expect(plot.line('heel')).toContainText('2.00');
  });
});

test('a plot tells and saves its numbers', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/level', 'double', 4.5);
  const plot = new PlotPage((await room.atDesk()).page);
  await plot.open('/lab/level');
  await expect(plot.line('value')).toContainText('4.50');

  await test.step('a record is found from the plot, with the times of both clocks', async () => {
    await plot.plot.focus();
    await plot.page.keyboard.press('Enter');
    const record = plot.page.getByRole('region', { name: 'Record 1' });
    await expect(record).toContainText('Timestamp');
    await expect(record).toContainText('Arrival time');
    await expect(record).toContainText('4.5');
    await record.getByRole('button', { name: 'Close the record' }).click();
    await expect(record).toBeHidden();
  });

  await test.step('two cursors tell what lies between them, and are moved with keys', async () => {
    const cursors = plot.page.getByRole('button', { name: /^Two cursors/ });
    await cursors.click();
    await expect(plot.numbers).toContainText('Δt 4.000 s');
    await expect(plot.numbers).toContainText('1/Δt 0.250 Hz');
    await plot.page.getByRole('slider', { name: 'Cursor A' }).focus();
    await plot.page.keyboard.press('Shift+ArrowRight');
    await expect(plot.numbers).toContainText('Δt 3.500 s');
    await cursors.click();
    await expect(plot.numbers).toHaveCount(0);
  });

  await test.step('what is shown is saved as a table and as a picture', async () => {
    await plot.plot.focus();
    for (let press = 0; press < 14; press++) await plot.page.keyboard.press('-');
    await expect(plot.plot).toHaveAccessibleName(/over 10 min/);
    const takenMs = Date.now();
    for (const [i, value] of [1.5, Number.NaN, -2].entries()) {
      robot.publish('/lab/level', 'double', value, { immediate: true, timestampMs: takenMs + i });
    }
    await expect(plot.line('value')).toContainText('−2.00');
    const table = await plot.save('Save the shown values as CSV');
    expect(table.suggestedFilename()).toBe('lab-level.csv');
    const rows = (await readFile(await table.path(), 'utf8')).trimEnd().split('\r\n');
    expect(rows[0]).toBe('time,time_ms,value');
    expect(rows.slice(-3).map((row) => row.split(',')[2])).toEqual(['1.5', 'NaN', '-2']);
    for (const row of rows.slice(1)) {
      expect(row).toMatch(/^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z,\d{13}(\.\d{1,3})?,/);
    }

    const picture = await plot.save('Save the picture as PNG');
    expect(picture.suggestedFilename()).toBe('lab-level.png');
    const bytes = await readFile(await picture.path());
    expect(bytes.subarray(1, 4).toString()).toBe('PNG');
    expect(bytes.length).toBeGreaterThan(1000);
  });
});
