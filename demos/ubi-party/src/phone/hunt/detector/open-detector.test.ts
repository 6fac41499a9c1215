import { expect, it } from 'vitest';

import { inTurn } from './open-detector.ts';

it('begins with a picture when the one before is done, also when that failed', async () => {
  const begun: number[] = [];
  const ends: ((isGood: boolean) => void)[] = [];
  const detect = inTurn((picture: number) => {
    begun.push(picture);
    return new Promise<string>((resolve, reject) =>
      ends.push((isGood) => (isGood ? resolve(`in ${picture}`) : reject(new Error('blurred')))),
    );
  });
  const [first, second, third] = [detect(1), detect(2), detect(3)];
  await Promise.resolve();
  expect(begun).toEqual([1]);
  ends[0]!(true);
  expect(await first).toBe('in 1');
  await Promise.resolve();
  ends[1]!(false);
  await expect(second).rejects.toThrow('blurred');
  await new Promise(setImmediate);
  ends[2]!(true);
  expect(await third).toBe('in 3');
  expect(begun).toEqual([1, 2, 3]);
});
