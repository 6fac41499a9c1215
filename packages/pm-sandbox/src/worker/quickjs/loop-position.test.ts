import { describe, expect, it } from 'vitest';
import { createEngineSandboxes } from '../../testing/inline-sandboxes.ts';
import { faultFrom, openSandbox } from '../../testing/sandbox-fixture.ts';
import { loopPosition } from './loop-position.ts';
import { createQuickJsEngine } from './quickjs-engine.ts';

const START = { line: 1, column: 1 };

describe('loopPosition', () => {
  it.each([
    ['() => {\n  const a = 1;\n  for (;;) {}\n}', 3],
    ['function () {\n  while (true) {\n    for (;;) {}\n  }\n}', 2],
    ['async (a, b = {}) => {\n  do {\n  } while (true);\n}', 2],
    ['() => {\n  // for (;;)\n  const text = "while (1)";\n  /* do */\n  while (1);\n}', 5],
    ['({\n  go(a) {\n    for (;;) ;\n  }\n}).go', 3],
    // With two loops, the position is unknown.
    ['() => {\n  for (const a of []) {}\n  while (1) {}\n}', 1],
    ['() => {\n  const format = 1;\n  state.do(format);\n}', 1],
    ['x', 1],
    ['() => {', 1],
  ])('%j: line %i', (source, line) => {
    const start = source.startsWith('({') ? { line: 2, column: 3 } : START;
    expect(loopPosition(source, start).line).toBe(line === 1 ? start.line : line);
  });

  it('is after what the engine knows, when one loop is there', () => {
    const source = '(d, inputs) => {\n  if (inputs.a) return;\n  for (;;) {}\n}';
    expect(loopPosition(source, { line: 2, column: 14 }).line).toBe(3);
    expect(loopPosition(`${source} + ((x) => { while (1); })`, { line: 2, column: 14 }).line).toBe(
      2,
    );
    expect(loopPosition(source, { line: 3, column: 11 }).line).toBe(3);
  });

  it('is what a killed module reports [PM-53]', async () => {
    const factory = createEngineSandboxes(
      await createQuickJsEngine({ stackBytes: 64_000, nowMs: () => performance.now() }),
    );
    for (const [onProcessing, line] of [
      ['() => {\n  let a = 1;\n  for (;;) { a++ }\n}', 3],
      ['() => {\n  for (;;) {\n    Math.sqrt(2);\n  }\n}', 3],
      ['(d, inputs) => {\n  if (inputs.none) return;\n  const a = Math.PI; for (;;) {}\n}', 3],
      ['() => {\n  const inner = () => {\n    while (true);\n  };\n  inner();\n}', 3],
    ] as const) {
      const { sandbox, run } = openSandbox(
        factory,
        { onProcessing, limits: { callTimeoutMs: 50 } },
        false,
      );
      await sandbox.create();
      expect(await faultFrom(run())).toMatchObject({ kind: 'timeout', line });
    }
  });
});
