import { type Client, type Init, type ServiceRequest } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';

const LONG = 'x'.repeat(3_800_000);

const register = (master: TestMaster, client: Init<Client>) =>
  master.call({ topic: '/services/client/registration', client });

/** The text of everything the master keeps for people: events, problems, lines of the log. */
async function toldBytes(master: TestMaster): Promise<number> {
  const { masterStatus } = await master.call({
    topic: '/services/ubii/master_status',
    masterStatusRequest: {},
  });
  const { logTail } = await master.call({
    topic: '/services/ubii/log_tail',
    logRequest: { level: 3 },
  });
  return JSON.stringify([masterStatus?.events, masterStatus?.problems, logTail]).length;
}

describe('texts of clients', () => {
  it('of 3.8 million characters in a name leave nothing of their length in status and log [EX-70] [EX-72]', async () => {
    const master = new TestMaster();
    for (let i = 0; i < 40; i++) {
      const { client } = await register(master, { name: `${i}${LONG}` });
      expect(client?.name).toHaveLength(100);
    }
    expect(await toldBytes(master)).toBeLessThan(100_000);
    const written = master.log.lines.map((line) => JSON.stringify(line).length);
    expect(Math.max(...written)).toBeLessThan(2_000);
  });

  it('that only describe are cut, in clients, devices and components [EX-70]', async () => {
    const master = new TestMaster();
    const { client } = await register(master, {
      name: 'Ada',
      description: LONG,
      tags: [LONG, ...Array<string>(5_000).fill('tag')],
      devices: [
        { name: LONG, description: LONG, components: [{ description: LONG, tags: ['a', LONG] }] },
      ],
    });
    expect(client?.description).toHaveLength(4096);
    expect(client?.tags).toHaveLength(256);
    expect(client?.tags[0]).toHaveLength(100);
    const device = client!.devices[0]!;
    expect([device.name.length, device.description.length]).toEqual([100, 4096]);
    expect(device.components[0]!.tags.map(({ length }) => length)).toEqual([1, 100]);
    expect(device.components[0]!.description).toHaveLength(4096);
  });

  it('keep whole characters when they are cut, and stand on one line as names [EX-70]', async () => {
    const master = new TestMaster();
    const { client } = await register(master, { name: '😀'.repeat(150) });
    expect(client?.name).toBe('😀'.repeat(100));
    const { client: second } = await register(master, { name: 'Ada\u202e\n\u001b[2Jevil' });
    expect(second?.name).toBe('Ada [2Jevil');
    const { client: third } = await register(master, { name: ' Ben ' });
    expect(third?.name).toBe(' Ben ');
  });

  const REFUSED: readonly (readonly [string, string, Init<ServiceRequest>])[] = [
    [
      'session.name',
      'identifierCharacters',
      { topic: '/services/session/runtime/add', session: { name: LONG } },
    ],
    [
      'session.processing_modules[1].name',
      'identifierCharacters',
      {
        topic: '/services/session/runtime/start',
        session: { name: 's', processingModules: [{ name: 'a' }, { name: LONG }] },
      },
    ],
    [
      'session.io_mappings[0].input_mappings[1].input_name',
      'identifierCharacters',
      {
        topic: '/services/session/runtime/add',
        session: { ioMappings: [{ inputMappings: [{}, { inputName: LONG }] }] },
      },
    ],
    [
      'session.io_mappings[0].input_mappings[0].topic_mux.name',
      'identifierCharacters',
      {
        topic: '/services/session/runtime/add',
        session: { ioMappings: [{ inputMappings: [{ topicMux: { name: LONG } }] }] },
      },
    ],
    [
      'session.description',
      'descriptionCharacters',
      { topic: '/services/session/database/save', session: { name: 's', description: LONG } },
    ],
    [
      'processing_module.tags',
      'textsPerList',
      {
        topic: '/services/processing_module/database/save',
        processingModule: { name: 'm', tags: Array<string>(300).fill('tag') },
      },
    ],
    [
      'processing_module.inputs[1].description',
      'ioDescriptionCharacters',
      {
        topic: '/services/processing_module/database/save',
        processingModule: { name: 'm', inputs: [{}, { description: LONG }] },
      },
    ],
    [
      'session.processing_modules[0].inputs[0].choices[1]',
      'choiceCharacters',
      {
        topic: '/services/session/runtime/add',
        session: { processingModules: [{ inputs: [{ choices: ['auto', LONG] }] }] },
      },
    ],
    [
      'client.devices[0].components[2].topic',
      'topicBytes',
      {
        topic: '/services/client/registration',
        client: { name: 'Ada', devices: [{ components: [{}, {}, { topic: LONG }] }] },
      },
    ],
    ['client.id', 'idCharacters', { topic: '/services/client/registration', client: { id: LONG } }],
    [
      'client_rename_request.name',
      'nameCharacters',
      { topic: '/services/ubii/client_rename', clientRenameRequest: { targetId: 'a', name: LONG } },
    ],
    [
      'access_grant_create_request.label',
      'nameCharacters',
      {
        topic: '/services/ubii/access_grant_create',
        accessGrantCreateRequest: { label: LONG, role: 2 },
      },
    ],
  ];

  it.each(REFUSED)(
    'that identify are refused: %s, by the limit %s [EX-70]',
    async (member, limit, request) => {
      const master = new TestMaster();
      const { error } = await master.call(request);
      expect(error?.code).toBe('resource_exhausted');
      expect(error?.message).toContain(`The member ${member} has `);
      expect(error?.message).toContain(`(limit ${limit})`);
      expect(error!.message.length).toBeLessThan(500);
      expect(await toldBytes(master)).toBeLessThan(100_000);
    },
  );

  it('of ordinary length are taken as they are [EX-70]', async () => {
    const master = new TestMaster();
    const description = 'A line.\n\tAnother one.';
    const { client } = await register(master, { name: 'Ada', description, tags: ['a', 'b'] });
    expect(client).toMatchObject({ name: 'Ada', description, tags: ['a', 'b'] });
  });

  it('of reasons are cut to one line [EX-70]', async () => {
    const master = new TestMaster();
    const ada = await master.extension('Ada');
    await master.call({
      topic: '/services/ubii/client_throttle',
      clientThrottleRequest: { targetId: ada.id, recordsPerSecond: 1, reason: `a\nb${LONG}` },
    });
    const { clientReport } = await master.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: {},
    });
    expect(clientReport?.clients[0]?.throttle?.reason).toBe(`a b${'x'.repeat(197)}`);
  });

  it('move with the limits that the operator sets [EX-70]', async () => {
    const master = new TestMaster({ limits: { nameCharacters: 5 } });
    const { client } = await register(master, { name: 'Ada Lovelace' });
    expect(client?.name).toBe('Ada L');
  });
});

describe('the log', () => {
  it('takes so many bytes a second, says how much it left out, and keeps room for errors [EX-72]', () => {
    const master = new TestMaster();
    master.log.lines.splice(0);
    const line = 'y'.repeat(1_000);
    for (let i = 0; i < 10_000; i++) master.logTail.info(line);
    const written = master.log.lines.length;
    expect(written).toBeLessThan(400);
    master.logTail.error('the disk is full');
    expect(master.log.lines.slice(written)).toMatchObject([
      { level: 'warn', fields: { lines: 10_000 - written } },
      { level: 'error', message: 'the disk is full' },
    ]);
    master.clock.advanceSync(1_000);
    for (let i = 0; i < 100; i++) master.logTail.info(line);
    expect(master.log.lines.length).toBeLessThan(written + 20);
  });

  it('keeps a million characters at most [EX-37]', async () => {
    const master = new TestMaster({ limits: { logBytesPerSecond: 1e9 } });
    const field = 'z'.repeat(1_000);
    for (let i = 0; i < 1_000; i++) {
      master.clock.advanceSync(30_000);
      master.logTail.info('much', { a: field, b: field, c: field, d: field });
    }
    const { logTail } = await master.call({
      topic: '/services/ubii/log_tail',
      logRequest: { level: 2 },
    });
    expect(logTail!.lines.length).toBeGreaterThan(200);
    expect(JSON.stringify(logTail).length).toBeLessThan(1_200_000);
  });

  it('cuts what is too long in a line [EX-37] [EX-72]', () => {
    const master = new TestMaster();
    master.log.lines.splice(0);
    master.logTail.error(LONG, { a: LONG, stack: `Error\n${LONG}`, n: 3 });
    expect(JSON.stringify(master.log.lines).length).toBeLessThan(12_000);
    expect(master.log.lines[0]).toMatchObject({ level: 'error', fields: { n: 3 } });
  });
});
