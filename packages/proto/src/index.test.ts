import { expect, it } from 'vitest';
import * as proto from './index.ts';
import * as wire from './wire/index.ts';

it('the package exports these names and no others', () => {
  expect(Object.keys(proto).sort()).toMatchSnapshot();
  expect(Object.keys(wire).sort()).toMatchSnapshot();
});
