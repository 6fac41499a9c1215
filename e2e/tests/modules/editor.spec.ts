import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { UbiiClient } from '@ubii/client-web';
import type { MasterEndpoints } from '@ubii/harness';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { ModuleEditor } from '../../pages/module-editor.ts';
import { ModulesPage } from '../../pages/modules-page.ts';
import { Shell } from '../../pages/shell.ts';

const DOUBLER = {
  name: 'doubler',
  description: 'Twice the number.',
  inputs: [{ internalName: 'value', messageFormat: 'double' }],
  outputs: [{ internalName: 'result', messageFormat: 'double' }],
  processingMode: { triggerOnInput: {} },
  onProcessingStringified:
    '(deltaTimeMs, inputs) => {\n  if (!inputs.value) return;\n  return { outputs: { result: { double: 2 * inputs.value.double } } };\n}',
};

async function store(endpoints: MasterEndpoints): Promise<void> {
  await callService(endpoints, {
    topic: '/services/processing_module/database/save',
    processingModule: DOUBLER,
  });
}

/** A session that uses a module by its name alone, from `/in` to `/out`. */
async function startSession(endpoints: MasterEndpoints, name: string): Promise<string> {
  const { session, error } = await callService(endpoints, {
    topic: '/services/session/runtime/start',
    session: {
      name: 'Numbers',
      processingModules: [{ name }],
      ioMappings: [
        {
          processingModuleName: name,
          inputMappings: [{ inputName: 'value', topic: '/in' }],
          outputMappings: [{ outputName: 'result', topic: '/out' }],
        },
      ],
    },
  });
  if (!session) throw new Error(error?.message);
  return session.id;
}

/** Publishes until the session answers with a number. */
async function expectAnswer(program: UbiiClient, given: number, wanted: number): Promise<void> {
  let newest: unknown;
  const subscription = program.subscribe('/out', { format: 'double' });
  subscription.onRecord(({ value }) => (newest = value));
  await subscription.ready;
  await expect
    .poll(() => {
      program.publish('/in', 'double', given);
      return newest;
    })
    .toBe(wanted);
  await subscription.close();
}

test('a module is written, tried, saved, used by a session, changed under it and broken @smoke', async ({
  master,
  room,
}) => {
  test.slow();
  const anna = await room.atDesk('Anna');
  const editor = new ModuleEditor(anna);

  await test.step('it begins with a template', async () => {
    await editor.create('Blank');
    await editor.about.getByLabel('Name', { exact: true }).fill('times');
    await expect(editor.lines.first()).toContainText('onProcessing');
  });

  await test.step('the editor knows its inputs', async () => {
    await editor.typeAfter('!inputs.value', '');
    await anna.page.keyboard.press('Enter');
    await anna.page.keyboard.insertText('const factor = inputs.value');
    await anna.page.keyboard.type('.');
    await expect(
      anna.page.locator('.suggest-widget .monaco-list-row').filter({ hasText: 'double' }),
    ).toBeVisible();
    await anna.page.keyboard.press('Escape');
    await anna.page.keyboard.insertText('wrong;');
    await expect(editor.problems).toContainText("Property 'wrong' does not exist");
    await anna.page.keyboard.press('Shift+Home');
    await anna.page.keyboard.insertText('const factor = 2;');
    await expect(editor.problems).toContainText('No problems found.');
  });

  await test.step('it is tried before anything is saved', async () => {
    await editor.typeAfter('return { outputs', '');
    for (let letter = 0; letter < ' } } };'.length; letter += 1) {
      await anna.page.keyboard.press('ArrowLeft');
    }
    await anna.page.keyboard.insertText(' * factor');
    await editor.input('value').getByRole('textbox', { name: 'value' }).fill('21');
    await editor.step();
    await expect(editor.output('result')).toContainText('42');
    await expect(editor.tryIt.getByRole('img', { name: /^Run time/ })).toBeVisible();
  });

  await test.step('unsaved work is there after a reload', async () => {
    await anna.page.reload();
    await editor.expectCode('const factor = 2;');
    await expect(anna.page.getByRole('status').filter({ hasText: 'Not saved yet' })).toBeVisible();
  });

  const program = await room.program('numbers');
  let session = '';
  await test.step('it is saved, and a session uses it', async () => {
    await editor.saveIt();
    await expect(anna.page).toHaveURL(/\/modules\/times\/edit$/);
    session = await startSession(master.endpoints, 'times');
    await expectAnswer(program, 4, 8);
    await expect(anna.page.getByRole('link', { name: 'Numbers', exact: true })).toBeVisible();
  });

  await test.step('saving lets the session continue with it, and is still the same session', async () => {
    await editor.typeAfter('const factor', '');
    await anna.page.keyboard.press('ArrowLeft');
    await anna.page.keyboard.press('Backspace');
    await anna.page.keyboard.type('3');
    await editor.saveIt();
    await expectAnswer(program, 4, 12);
    const { sessionList } = await callService(master.endpoints, {
      topic: '/services/session/runtime/get_list',
    });
    expect(sessionList?.elements.map(({ id }) => id)).toEqual([session]);
  });

  await test.step('code with errors goes into a running session only when asked for', async () => {
    await editor.typeAfter('const factor', ' missing();');
    await expect(editor.problems).toContainText("Cannot find name 'missing'");
    await editor.save.click();
    const question = anna.page.getByRole('dialog', { name: 'Save code with errors' });
    await expect(question).toContainText('The code has 1 error. Numbers would run it immediately.');
    await question.getByRole('button', { name: 'Cancel' }).click();
    await expectAnswer(program, 4, 12);
    await editor.typeAfter('missing();', '');
    await anna.page.keyboard.press('Shift+Home');
    await anna.page.keyboard.insertText('const factor = 3;');
    await expect(editor.problems).toContainText('No problems found.');
  });

  await test.step('an endless loop is ended and named, at its line', async () => {
    await editor.typeAfter('const factor', ' for (;;) {}');
    await editor.step();
    await expect(editor.tryIt.getByRole('alert')).toContainText('longer than');
    await expect(editor.tryIt.getByRole('alert')).toContainText('Line 4');
    await expect(editor.problems.getByRole('button')).toContainText(['4:']);
  });

  await test.step('what does not parse is not saved, and says where', async () => {
    await editor.typeAfter('for (;;)', ' +');
    await expect(editor.problems).toContainText('Expression expected');
    await expect(editor.save).toHaveAttribute('aria-description', /^Line \d+: /);
    await expectAnswer(program, 5, 15);
  });

  await test.step('an earlier version is compared, restored and used', async () => {
    await editor.beside('Versions');
    const list = editor.versions.getByRole('list', { name: 'Versions, newest first' });
    await expect(list.getByRole('listitem')).toHaveCount(2);
    await list.getByRole('button').last().click();
    await expect(
      editor.comparison.locator('.view-line').filter({ hasText: 'factor' }).first(),
    ).toBeVisible();
    await editor.comparison.getByRole('button', { name: 'Restore' }).click();
    await editor.expectCode('const factor = 2;');
    await editor.saveIt();
    await expectAnswer(program, 5, 10);
    await expect(list.getByRole('listitem')).toHaveCount(3);
  });
});

test('a stored module is opened, changed on both sides, renamed and tried', async ({
  master,
  room,
}) => {
  await store(master.endpoints);
  const anna = await room.atDesk('Anna');
  const editor = new ModuleEditor(anna);
  await test.step('only the editor loads the code editor', async () => {
    const loaded: string[] = [];
    anna.page.on('request', (request) => {
      if (/monaco|editor\.api|ts\.worker|editor\.worker/i.test(request.url())) {
        loaded.push(request.url());
      }
    });
    await anna.page.goto('/');
    for (const page of ['Sessions', 'Topics', 'Modules']) {
      await new Shell(anna.page).go(page);
      await expect(anna.page).toHaveURL(new RegExp(`/${page.toLowerCase()}$`));
      await expect(anna.page.getByRole('heading', { level: 1 })).toBeAttached();
    }
    const modules = new ModulesPage(anna);
    expect(loaded).toEqual([]);
    await modules.link('doubler').click();
    await expect(modules.detail).toContainText('Twice the number.');
    await editor.open('doubler');
    await editor.expectCode('2 * inputs.value.double');
    expect(loaded.length).toBeGreaterThan(0);
  });

  await test.step('what is changed on the disk of the master appears, and asks when both changed', async () => {
    await editor.expectCode('2 * inputs.value.double');
    const file = join(master.dataDir, 'modules/doubler.pm');
    const change = async (from: string, to: string): Promise<void> =>
      writeFile(file, (await readFile(file, 'utf8')).replace(from, to));

    await change('2 * inputs', '7 * inputs');
    await editor.expectCode('7 * inputs.value.double');

    const description = editor.about.getByLabel('Description', { exact: true });
    await description.fill('Mine.');
    await change('7 * inputs', '9 * inputs');
    const question = anna.page.getByRole('alert', { name: 'Changed on both sides' });
    await expect(question).toBeVisible();
    await expect(editor.save).toHaveAttribute('aria-description', /^Another client/);
    await question.getByRole('button', { name: 'Compare' }).click();
    await expect(question.locator('.view-line').filter({ hasText: '9' }).first()).toBeVisible();
    await question.getByRole('button', { name: 'Keep mine' }).click();
    await expect(question).toHaveCount(0);
    await editor.expectCode('7 * inputs.value.double');
    await expect(description).toHaveValue('Mine.');

    await change('9 * inputs', '11 * inputs');
    await question.getByRole('button', { name: 'Take theirs' }).click();
    await editor.expectCode('11 * inputs.value.double');
    await expect(description).toHaveValue('Twice the number.');
  });

  await test.step('a module is renamed, tried with a live topic and a pasted record, and wrong fields say why', async () => {
    await store(master.endpoints);
    await editor.expectCode('2 * inputs.value.double');
    const program = await room.program('numbers');

    const name = editor.about.getByLabel('Name', { exact: true });
    await name.fill('clock');
    await expect(editor.about.getByRole('alert')).toContainText('A module named clock exists');
    await name.fill('twice');
    await editor.saveIt();
    await expect(anna.page).toHaveURL(/\/modules\/twice\/edit$/);

    program.publish('/live', 'double', 8);
    const input = editor.input('value');
    await input.getByRole('radio', { name: 'Topic' }).click();
    await input.getByRole('button', { name: '/live' }).click();
    await expect
      .poll(async () => {
        await editor.step();
        return editor.output('result').innerText();
      })
      .toContain('16');

    await input.getByRole('radio', { name: 'Record' }).click();
    const record = input.getByRole('textbox', { name: 'Record for value' });
    await record.fill('{ "vector2": { "x": 1 } }');
    await expect(input.getByRole('alert')).toContainText('vector2');
    await record.fill('{ "topic": "/pasted", "double": 50 }');
    await expect(input.getByRole('alert')).toHaveCount(0);
    await editor.step();
    await expect(editor.output('result')).toContainText('100');

    const modules = new ModulesPage(anna);
    await modules.open();
    await expect(modules.link('twice')).toBeVisible();
    await expect(modules.link('doubler')).toHaveCount(0);
  });
});

test('a phone has a plain editor with the same checks', async ({ master, room }) => {
  await store(master.endpoints);
  const ben = await room.withPhone('Ben');
  const editor = new ModuleEditor(ben);
  await editor.open('doubler');
  const code = ben.page.getByRole('textbox', { name: 'Code of the module' });
  await expect(code).toHaveValue(/2 \* inputs/);
  await code.fill('onProcessing = (deltaTimeMs, inputs) => {\n  retrn 3;\n};\n');
  await expect(editor.problems).toContainText('2:');
  await code.fill(
    'onProcessing = (deltaTimeMs, inputs) => ({ outputs: { result: { double: 5 } } });\n',
  );
  await expect(editor.problems).toContainText('No problems found.');
  await editor.beside('Try it');
  await editor.step();
  await expect(editor.output('result')).toContainText('5');
  await editor.saveIt();
  const overflow = await ben.page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  expect(overflow).toBe(0);
  await ben.page.getByRole('link', { name: 'Use in a session' }).tap();
  await expect(ben.page).toHaveURL(/\/sessions\/[^/]+$/);
  await expect(ben.page.getByText('doubler', { exact: true }).first()).toBeVisible();
});
