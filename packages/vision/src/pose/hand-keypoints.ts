/**
 * The 21 keypoints of a hand, in the order of MediaPipe's hand landmarks: the wrist, then of each finger
 * from its root to its tip.
 */
export const HAND_KEYPOINTS = [
  'wrist',
  ...(['thumbCmc', 'thumbMcp', 'thumbIp', 'thumbTip'] as const),
  ...(['indexMcp', 'indexPip', 'indexDip', 'indexTip'] as const),
  ...(['middleMcp', 'middlePip', 'middleDip', 'middleTip'] as const),
  ...(['ringMcp', 'ringPip', 'ringDip', 'ringTip'] as const),
  ...(['pinkyMcp', 'pinkyPip', 'pinkyDip', 'pinkyTip'] as const),
] as const;

export type HandKeypointName = (typeof HAND_KEYPOINTS)[number];

/** Keypoints that a line joins in a drawing of the hand. */
export const HAND_BONES: readonly (readonly [HandKeypointName, HandKeypointName])[] = [
  ['wrist', 'thumbCmc'],
  ['thumbCmc', 'thumbMcp'],
  ['thumbMcp', 'thumbIp'],
  ['thumbIp', 'thumbTip'],
  ['wrist', 'indexMcp'],
  ['indexMcp', 'indexPip'],
  ['indexPip', 'indexDip'],
  ['indexDip', 'indexTip'],
  ['indexMcp', 'middleMcp'],
  ['middleMcp', 'middlePip'],
  ['middlePip', 'middleDip'],
  ['middleDip', 'middleTip'],
  ['middleMcp', 'ringMcp'],
  ['ringMcp', 'ringPip'],
  ['ringPip', 'ringDip'],
  ['ringDip', 'ringTip'],
  ['ringMcp', 'pinkyMcp'],
  ['wrist', 'pinkyMcp'],
  ['pinkyMcp', 'pinkyPip'],
  ['pinkyPip', 'pinkyDip'],
  ['pinkyDip', 'pinkyTip'],
];
