import { SessionState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../testing/a-session.ts';
import { sessionSketch } from './session-sketch.ts';

describe('sessionSketch', () => {
  it('has what flows in at the left, modules between, what flows out at the right', () => {
    const { boxes, wires } = sessionSketch(aSession());
    const at = (kind: string) => boxes.filter((box) => box.kind === kind).map(({ x }) => x);
    const [module] = at('module');
    const [input, output] = at('topic');
    expect(input).toBeLessThan(module!);
    expect(output).toBeGreaterThan(module!);
    expect(wires.map(({ family }) => family)).toEqual(['vector', 'vector']);
  });

  it('stays in its frame, whatever the session: cycles, long chains, nothing at all', () => {
    const chain = aSession();
    const [module] = chain.processingModules;
    const [mapping] = chain.ioMappings;
    for (let index = 0; index < 12; index += 1) {
      const id = `m${index}`;
      chain.processingModules.push({ ...module!, id });
      chain.ioMappings.push({
        ...mapping!,
        processingModuleId: id,
        inputMappings: [{ ...mapping!.inputMappings[0]!, topic: `/t${index}` }],
        outputMappings: [{ ...mapping!.outputMappings[0]!, topic: `/t${(index + 1) % 12}` }],
      });
    }
    for (const { x, y, width, height } of sessionSketch(chain).boxes) {
      expect([x >= 0, y >= 0, x + width <= 96, y + height <= 54]).toEqual([true, true, true, true]);
    }
    expect(sessionSketch(aSession({ json: { processingModules: [] } })).boxes).toEqual([]);
  });

  it('marks a module with an error', () => {
    const session = aSession({ state: SessionState.SESSION_DEGRADED });
    session.extension!.problems.push({
      isError: true,
      moduleId: 'module',
      code: '',
      message: '',
      path: '',
      moduleName: '',
      nodeId: '',
      line: 0,
      column: 0,
    });
    expect(sessionSketch(session).boxes.find(({ kind }) => kind === 'module')?.isTroubled).toBe(
      true,
    );
  });
});
