import type { ModuleText } from '../../text/module-text.ts';

const ARROW = /^(?:async\s+)?\(?\s*([\w$]+)\s*\)?\s*=>\s*\{/;
const FUNCTION = /^(?:async\s+)?function\s*[\w$]*\s*\(\s*([\w$]+)\s*\)\s*\{/;

/**
 * Source of a class with the members that `onCreated` assigns to the state: TypeScript infers their types from the
 * assignments in its constructor. Empty class without such members.
 */
export function stateSource({ sections }: ModuleText): string {
  const created = sections.find(({ callback }) => callback === 'onCreated')?.source ?? '';
  const head = ARROW.exec(created) ?? FUNCTION.exec(created);
  const end = created.lastIndexOf('}');
  const name = head?.[1];
  const body =
    head && name !== undefined && end > head[0].length
      ? created
          .slice(head[0].length, end)
          // eslint-disable-next-line ubii/no-native-patterns -- one name, escaped, without repetitions
          .replaceAll(new RegExp(`(?<![\\w$.])${name.replaceAll('$', '\\$')}\\.`, 'g'), 'this.')
      : '';
  return `export class OwnState {\n  constructor() {\n${body}\n  }\n}\n`;
}
