import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const MODULE = 'virtual:learn-reference';
const RESOLVED = `\0${MODULE}`;

const root = new URL('../../', import.meta.url);
/** @param {string} path */
const file = (path) => fileURLToPath(new URL(path, root));

/**
 * The comments of a proto file, by the full name of the message and the JSON name of the field.
 *
 * @param {string} text
 * @returns {Record<string, { comment: string, fields: Record<string, { comment: string, number: number, type: string }> }>}
 */
export function protoComments(text) {
  /** @type {ReturnType<typeof protoComments>} */
  const found = {};
  /** @type {{ name: string, kind: string }[]} */
  const open = [];
  let comment = '';
  let packageName = '';
  for (const line of text.split('\n').map((one) => one.trim())) {
    if (line.startsWith('//')) {
      comment = `${comment} ${line.slice(2).trim()}`.trim();
      continue;
    }
    const named = /^(message|enum|oneof)\s+(\w+)\s*\{(\s*\})?/.exec(line);
    const field = /^(repeated\s+)?([\w.]+(?:<[^>]+>)?)\s+(\w+)\s*=\s*(\d+)\s*(?:\[[^\]]*\])?;/.exec(
      line,
    );
    packageName = /^package\s+([\w.]+);/.exec(line)?.[1] ?? packageName;
    if (named) {
      const [, kind = '', name = '', isClosed] = named;
      if (kind === 'message') {
        const path = [...open.map((one) => one.name), name].join('.');
        found[`${packageName}.${path}`] = { comment, fields: {} };
      }
      if (!isClosed) open.push({ name, kind });
    } else if (line === '}') {
      open.pop();
    } else if (field) {
      const [, repeated = '', type = '', name = '', number = ''] = field;
      const inside = open.filter((one) => one.kind === 'message').map((one) => one.name);
      const message = found[`${packageName}.${inside.join('.')}`];
      if (message && open.at(-1)?.kind !== 'enum') {
        const jsonName = name.replace(/_(\w)/g, (_all, letter) => letter.toUpperCase());
        message.fields[jsonName] = { comment, number: Number(number), type: `${repeated}${type}` };
      }
    }
    comment = '';
  }
  return found;
}

/**
 * The rows of the first table in a Markdown text, without its head.
 *
 * @param {string} text
 * @returns {string[][]}
 */
export function markdownTable(text) {
  const lines = text.split('\n');
  const start = lines.findIndex((line) => /^\|\s*-/.test(line));
  const rows = [];
  for (const line of start < 0 ? [] : lines.slice(start + 1)) {
    if (!line.startsWith('|')) break;
    const cells = line.split('|').slice(1, -1);
    rows.push(cells.map((cell) => cell.trim()));
  }
  return rows;
}

/** Everything that the reference pages show and that is not in a package of the frontend. */
async function readReference() {
  const schema = file('packages/proto/schema/');
  const messages = {};
  for (const name of readdirSync(schema, { recursive: true, encoding: 'utf8' }).sort()) {
    if (!name.endsWith('.proto')) continue;
    Object.assign(messages, protoComments(readFileSync(`${schema}${name}`, 'utf8')));
  }
  const options = { configFile: false, root: file('.'), logLevel: 'error' };
  const { module: services } = await runnerImport(
    file('apps/master/src/core/services/all-services.ts'),
    options,
  );
  const { module: rights } = await runnerImport(
    file('apps/master/src/core/access/rights-table.ts'),
    options,
  );
  return {
    messages,
    serviceRights: Object.fromEntries(
      services.ALL_SERVICES.map(({ name, roles, audited }) => [name, { roles, audited }]),
    ),
    topicRights: Object.values(rights.TOPIC_RIGHTS),
    paths: rights.PATH_RIGHTS.map(({ method, path, content }) => ({ method, path, content })),
    sockets: Object.values(rights.SOCKET_RIGHTS).map(({ path, content }) => ({ path, content })),
    closeCodes: markdownTable(readFileSync(file('docs/spec/extensions.md'), 'utf8')),
    guides: markdownTable(readFileSync(file('docs/guides/README.md'), 'utf8')),
    glossary: markdownTable(readFileSync(file('docs/glossary.md'), 'utf8')),
  };
}

/**
 * Vite plugin: the facts of the reference pages of `/learn`, read from their sources when the frontend is
 * built: schema, rights of the master, glossary, guides.
 *
 * @returns {import('vite').Plugin}
 */
export function learnReferencePlugin() {
  return {
    name: 'ubii-learn-reference',
    resolveId: (id) => (id === MODULE ? RESOLVED : undefined),
    async load(id) {
      if (id !== RESOLVED) return undefined;
      return `export const reference = ${JSON.stringify(await readReference())};`;
    },
  };
}
