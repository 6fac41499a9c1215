import { expect, it } from 'vitest';
import { computed, shallowRef } from 'vue';
import { editedModule } from './edited-module.ts';
import { TEMPLATES } from './templates.ts';

it('changes only the part that is edited', () => {
  const draft = shallowRef({ ...TEMPLATES[0]!.draft, name: 'a' });
  const module = editedModule(() => draft.value);
  let drawn = 0;
  const name = computed(() => ((drawn += 1), module.about.value.name));
  expect(name.value).toBe('a');
  const { inputs } = module.about.value;
  draft.value = { ...draft.value, code: 'onProcessing = () => {};' };
  expect(name.value).toBe('a');
  expect(module.about.value.inputs).toBe(inputs);
  expect(module.text.value.sections).toHaveLength(1);
  expect(drawn).toBe(1);
  const { value: text } = module.text;
  draft.value = { ...draft.value, name: 'b' };
  expect(name.value).toBe('b');
  expect(module.text.value).toBe(text);
});
