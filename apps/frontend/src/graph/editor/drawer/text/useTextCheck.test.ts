import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { nextTick, ref } from 'vue';
import { useTextCheck } from './useTextCheck.ts';

const TEXT = '{\n  "name": "x",\n  "processingModules": [\n    { "name": "m" }\n  ]\n}';
const problem = {
  isError: true,
  code: 'module_unknown',
  message: 'No node has "m".',
  path: 'processingModules[0]',
  moduleId: '',
  moduleName: 'm',
  nodeId: '',
  line: 0,
  column: 0,
};

describe('useTextCheck', () => {
  it('says what is wrong while one types, and nothing of an empty text', async () => {
    const text = ref('');
    const check = useTextCheck(text);
    expect(check.problems.value).toEqual([]);
    text.value = '{ "name" }';
    await nextTick();
    expect(check.problems.value).toMatchObject([{ isError: true, line: 1 }]);
  });

  it('hands a session on when it can be read', async () => {
    const check = useTextCheck(ref(TEXT));
    expect(await check.submit(async ({ name }) => name)).toBe('x');
    expect(check.problems.value).toEqual([]);
  });

  it('puts what the master finds on its lines, until the text is changed [SE-3]', async () => {
    const text = ref(TEXT);
    const check = useTextCheck(text);
    const refuse = async () => {
      throw new ServiceError('invalid_argument', 'It cannot.', {
        details: { problems: [problem] },
      });
    };
    expect(await check.submit(refuse)).toBeUndefined();
    expect(check.problems.value).toMatchObject([{ message: 'No node has "m".', line: 4 }]);
    expect(check.isTrying.value).toBe(false);
    text.value += '\n';
    await nextTick();
    expect(check.problems.value).toEqual([]);
  });

  it('says what else went wrong in one sentence', async () => {
    const check = useTextCheck(ref(TEXT));
    await check.submit(async () => {
      throw new ConnectionError('timeout', 'The master does not answer.');
    });
    expect(check.problems.value).toMatchObject([
      { message: 'The master does not answer.', line: undefined },
    ]);
  });
});
