import { Script } from 'node:vm';
import type { SourcePosition } from '../worker/v8/v8-engine.ts';

const FILE_NAME = 'ubii-module.js';

/**
 * Returns the position of a syntax error. V8 reports it only when a script with a filename is compiled: first line
 * `file:line`, then the line itself, then a mark under the position.
 *
 * @param text starts with one character that is not the author's
 */
export function locateSyntaxError(text: string): SourcePosition | undefined {
  try {
    new Script(text, { filename: FILE_NAME });
    return undefined;
  } catch (thrown) {
    const lines = String((thrown as Error).stack).split('\n');
    // eslint-disable-next-line ubii/no-native-patterns -- of a constant
    const line = Number(new RegExp(`^${FILE_NAME}:(\\d+)$`).exec(lines[0] ?? '')?.[1]);
    if (!(line > 0)) return undefined;
    const column = (lines[2] ?? '').indexOf('^') + 1;
    return { line, column: Math.max(1, column - (line === 1 ? 1 : 0)) };
  }
}
