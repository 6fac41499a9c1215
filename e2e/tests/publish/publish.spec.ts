import type { TopicRecord } from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { PublishPage } from '../../pages/publish-page.ts';
import { Shell } from '../../pages/shell.ts';

test('form and JSON are one record, and what is wrong stands beside the field and at its line @smoke @firefox', async ({
  room,
}) => {
  const publish = new PublishPage(await room.atDesk());
  await publish.open();
  await publish.topic.fill('/lab/point');
  await publish.choose('vector3');
  await publish.field('y').fill('2.5');
  await expect(publish.json).toHaveValue(/"y": 2\.5/);
  await publish.json.fill('{"topic":"/lab/point","vector3":{"x":7,"y":"up","z":0}}');
  await expect(publish.field('x')).toHaveValue('7');
  await expect(publish.field('y')).toHaveAttribute('aria-invalid', 'true');
  await expect(publish.form.getByText('Must be a number, got "up".')).toBeVisible();
  await expect(
    publish.page.getByRole('button', { name: /Line 1 vector3\.y must be/ }),
  ).toBeVisible();
  await publish.expectBlocked('vector3.y must be a number, got "up".');
  await publish.json.press('Control+Enter');
  const notPublished = publish.page.getByText(/Not published: vector3\.y must be a number/);
  await expect(notPublished).toBeVisible();
  await publish.json.fill('{"topic": ');
  await expect(notPublished).toHaveCount(0);
  await expect(publish.page.getByRole('button', { name: /Line 1 Expected a value/ })).toBeVisible();
  await publish.expectBlocked('The JSON is not valid. Line 1: Expected a value, found the end.');
  await expect(publish.sent).toContainText('0');
  await publish.json.fill('{"topic":"/lab/point","vector3":{"x":7,"y":1}}');
  await publish.publish();
  await expect(publish.sent).toContainText('1');
});

test('a record is published in other ways than by its button', async ({ room }) => {
  const robot = await room.program('Robot');
  const publish = new PublishPage(await room.atDesk());
  await publish.open();
  await new Shell(publish.page).expectConnected();

  await test.step('a record is repeated at a rate, with a new count in each, until it is stopped', async () => {
    const values: number[] = [];
    const subscription = robot
      .subscribe('/lab/count', { format: 'double' })
      .onRecord(({ value }) => values.push(value));
    await subscription.ready;
    await publish.topic.fill('/lab/count');
    await publish.field('double').fill('{{counter}}');
    await publish.page.getByRole('textbox', { name: 'Rate' }).fill('50');
    await publish.page.getByRole('button', { name: 'Repeat' }).click();
    await expect(publish.page.getByText('Repeating at')).toBeVisible();
    await expect.poll(() => values.length).toBeGreaterThan(3);
    await publish.page.getByRole('button', { name: 'Stop' }).click();
    await expect(publish.page.getByText('Not repeating')).toBeVisible();
    expect(values.slice(1)).not.toContain(values[0]);
  });

  await test.step('"Send while changing" publishes changed values, but no topic that is being typed', async () => {
    await publish.open();
    await new Shell(publish.page).expectConnected();
    const got: TopicRecord[] = [];
    await robot.subscribe({ glob: '/**' }).onRecord((record) => got.push(record)).ready;
    await publish.page.getByRole('switch', { name: /Send while changing/ }).click();
    await publish.topic.pressSequentially('lab/light');
    await expect(publish.page.getByText('"lab/light" and "/lab/light" are two')).toBeVisible();
    await publish.topic.fill('');
    await publish.topic.pressSequentially('/lab/light');
    await publish.topic.press('Enter');
    await publish.field('double').fill('7');
    await expect.poll(() => got.find(({ topic }) => topic === '/lab/light')?.value).toBe(7);
    const typed = got.filter(
      ({ topic }) => '/lab/light'.startsWith(topic) || topic.startsWith('lab'),
    );
    expect(new Set(typed.map(({ topic }) => topic))).toEqual(new Set(['/lab/light']));
  });

  await test.step('a topic that is there is continued: by pointing, turning and picking', async () => {
    robot.publish('/lab/point', 'vector2', { x: 0.25, y: -0.5 });
    await publish.open('/lab/point');
    await expect(publish.field('x')).toHaveValue('0.25');
    const got: TopicRecord[] = [];
    await robot.subscribe('/lab/point').onRecord((record) => got.push(record)).ready;
    await publish.page.getByRole('switch', { name: /Send while changing/ }).click();
    await publish.page.getByTestId('pad').click({ position: { x: 196, y: 4 } });
    await expect.poll(() => got.at(-1)?.value).toMatchObject({ x: expect.closeTo(1, 1) });
    await publish.choose('quaternion');
    await publish.page.getByRole('slider', { name: 'yaw, about z' }).press('End');
    await expect.poll(() => got.at(-1)?.value).toMatchObject({ z: 1 });
    await publish.choose('color');
    await publish.page.getByLabel('Colour', { exact: true }).fill('#ff0000');
    await expect.poll(() => got.at(-1)?.value).toMatchObject({ r: 1, g: 0, b: 0, a: 1 });
  });
});

test('records are published from files, and kept as snippets and by the master', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const publish = new PublishPage(await room.atDesk());
  await publish.open();
  await new Shell(publish.page).expectConnected();

  await test.step('a picture is published from a file', async () => {
    const got: TopicRecord[] = [];
    await robot.subscribe('/lab/picture').onRecord((record) => got.push(record)).ready;
    await publish.topic.fill('/lab/picture');
    await publish.choose('image2D');
    const png =
      'iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEElEQVR4nGP4z8AARAwQCgAf7gP9i18U1AAAAABJRU5ErkJggg==';
    await publish.form
      .locator('input[type=file]')
      .first()
      .setInputFiles({
        name: 'dot.png',
        mimeType: 'image/png',
        buffer: Buffer.from(png, 'base64'),
      });
    await expect(publish.page.getByAltText('The picture that is published')).toBeVisible();
    await publish.publish();
    await expect.poll(() => got.at(-1)?.value).toMatchObject({ width: 2, height: 2 });
  });

  await test.step('a record is kept as a snippet, and is there again after a reload', async () => {
    await publish.topic.fill('/lab/light');
    await publish.choose('bool');
    await publish.page.getByRole('textbox', { name: 'Name of the snippet' }).fill('light on');
    await publish.page.getByRole('button', { name: 'Save', exact: true }).click();
    const file = publish.page.waitForEvent('download');
    await publish.page.getByRole('button', { name: 'Export' }).click();
    const path = await (await file).path();
    await publish.page.reload();
    await publish.page.getByRole('button', { name: 'light on', exact: true }).click();
    await expect(publish.topic).toHaveValue('/lab/light');
    await expect(publish.json).toHaveValue(/"bool": false/);
    await publish.page.getByRole('button', { name: 'Delete light on' }).click();
    await expect(publish.page.getByRole('list', { name: 'Snippets' })).toHaveCount(0);
    await publish.page.locator('input[type=file]').last().setInputFiles(path);
    await expect(publish.page.getByRole('button', { name: 'light on', exact: true })).toBeVisible();
  });

  await test.step('a published value stays when its tab is reloaded and when it is closed', async () => {
    await publish.topic.fill('/lab/kept');
    await publish.choose('double');
    await publish.field('double').fill('0.25');
    await publish.publish();
    await expect(publish.sent).toContainText('1');
    await publish.page.reload();
    await new Shell(publish.page).expectConnected();
    await expect(
      publish.page.getByText('The master keeps the values for up to 60 min'),
    ).toBeVisible();
    await publish.page.close();
    const got: unknown[] = [];
    await robot.subscribe('/lab/kept').onRecord(({ value }) => got.push(value)).ready;
    await expect.poll(() => got).toEqual([0.25]);
  });
});

test('the publish page fits a phone, and its hints move no control', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/light', 'double', 1);
  robot.publish('/lab/angle', 'double', 0.5);
  const phone = (await room.withPhone()).page;

  await test.step('the page is found from the palette and from a topic, and fits a phone', async () => {
    await phone.goto('/topics/%2Flab%2Fangle');
    await phone.getByRole('button', { name: 'Publish', exact: true }).click();
    const head = phone.getByRole('region', { name: 'Publish', exact: true });
    await expect(head.getByRole('textbox', { name: 'double' })).toHaveValue('0.5');
    const got: unknown[] = [];
    await robot.subscribe('/lab/angle').onRecord(({ value }) => got.push(value)).ready;
    await head.getByRole('textbox', { name: 'double' }).fill('0.75');
    await expect.poll(() => got.at(-1)).toBe(0.75);
    await head.getByRole('button', { name: 'More' }).click();
    await expect(head.getByRole('textbox', { name: 'Record as JSON' })).toHaveValue(/0\.75/);
    const shell = new Shell(phone);
    expect(await shell.overflowPx()).toBe(0);
    await phone.goto('/');
    await shell.button('Search or run a command').click();
    await shell.palette.getByRole('combobox').fill('publish a record');
    await phone.keyboard.press('Enter');
    await expect(phone).toHaveURL(/\/publish$/);
    await shell.button('Search or run a command').click();
    await shell.palette.getByRole('combobox').fill('publish to angle');
    await phone.keyboard.press('Enter');
    await expect(head.getByRole('textbox', { name: 'double' })).toHaveValue('0.75');
  });

  await test.step('hints about the topic move no control', async () => {
    for (const { page } of [await room.atDesk(), { page: phone }]) {
      const publish = new PublishPage({ page });
      await publish.open();
      await new Shell(page).expectConnected();
      const button = page.getByRole('button', { name: 'Publish', exact: true });
      const before = await button.boundingBox();
      await publish.topic.pressSequentially('lab');
      await expect(page.getByText('"lab" and "/lab" are two different topics')).toBeVisible();
      expect(await button.boundingBox()).toEqual(before);
      await publish.topic.fill('/lab/light');
      await publish.choose('vector2');
      await expect(page.getByText('This topic holds double.')).toBeVisible();
      expect(await button.boundingBox()).toEqual(before);
    }
  });
});
