// Does the packed tarball work in a fresh project with Vite, React 19 and TypeScript? Tests typed props and events of
// elements and components, and a list of lights that follows state. Installs from the registry, so it is slow:
// @release.

import { allReady, expect, pixelAt, pixels, test } from '../support/test.js';
import { readmeSample, strictOptions, useFreshProject } from './fresh-project.js';

const app = `
import { StrictMode, useRef, useState } from 'react';
import { createRoot } from 'react-dom/client';
import 'phong-viewer';
import type { PhongLightProps, PhongViewer } from 'phong-viewer';

interface Lamp extends PhongLightProps {
  readonly number: number;
}

const red: Lamp = { number: 1, position: [0, 0, 1, 0], diffuse: [200, 0, 0], specular: 0 };
const blue: Lamp = { number: 2, position: '0 0 1 0', diffuse: '0 0 200', specular: [0, 0, 0] };

function App() {
  const viewer = useRef<PhongViewer>(null);
  const [lamps, setLamps] = useState<readonly Lamp[]>([red]);
  const [dim, setDim] = useState(false);
  const [source, setSource] = useState('nothing');
  return (
    <>
      <button onClick={() => setLamps([red, blue])}>add</button>
      <button onClick={() => setLamps([blue])}>remove</button>
      <button onClick={() => setDim(!dim)}>dim</button>
      <output>{source} {viewer.current?.camera.theta}</output>
      <phong-viewer
        ref={viewer}
        className="picture" style={{ display: 'block', width: 300, height: 200 }}
        alt="A sphere" geometry="sphere" kd={255} theta={0} phi="90"
        oncamera-change={(event) => setSource(event.detail.source)}
      >
        {lamps.map(({ number, ...props }) => (
          <phong-light key={number} {...props} active={!dim} />
        ))}
      </phong-viewer>
    </>
  );
}

createRoot(document.getElementById('root')!).render(<StrictMode><App /></StrictMode>);
`;

const refusals = `
import 'phong-viewer';
export const unknown = [
  // @ts-expect-error an angle is not a boolean
  <phong-viewer theta={true} />,
  // @ts-expect-error there is no such geometry
  <phong-mesh geometry="cube" />,
  // @ts-expect-error one number is not a position
  <phong-mesh position={2} />,
  // @ts-expect-error React's own onLoad never fires here
  <phong-viewer onLoad={() => undefined} />,
  // @ts-expect-error there is no such attribute
  <phong-light strength={2} />,
  // @ts-expect-error the event is another one
  <phong-viewer oncamera-change={(event: MouseEvent) => event} />,
];
export const known = [
  <phong-mesh scale={2} rotation="0 10 0" ka={128} onload={(event) => event.detail.url} aria-hidden />,
  <phong-viewer radius="auto" target={[0, 1, 2]} terms={['ambient']} crossOrigin={null} color-interpolation="linear" />,
  <phong-viewer helpers={['lights', 'grid']} view="n-dot-l" view-light="sun" probe probe-at="0 0 1" onprobe-change={(event) => event.detail.pinned} />,
  <phong-compare at={40} labels="Gouraud, Phong" ondivider-change={(event) => event.detail.at} />,
  <phong-control for="a" attribute="cutoff" component="x" max={60} type="slider">label</phong-control>,
  <phong-light position={[1, 2, 3]} active="false" space="camera" aperture={undefined} />,
];
`;

const components = `
import { createRef } from 'react';
import type { PhongViewer as Element } from 'phong-viewer';
import { PhongCompare, PhongLight, PhongMesh, PhongViewer, type PhongViewerElement, type PhongViewerProps } from 'phong-viewer/react';

const viewer = createRef<PhongViewerElement>();
const same: Element | null = viewer.current;
const props: PhongViewerProps = { radius: 'auto', target: [0, 1, 2], terms: ['ambient'], crossOrigin: null };
export const known = [
  <PhongViewer
    {...props} ref={viewer} key={1} className="wide" style={{ width: 10 }} data-kind="x" aria-label="A box" gui
    onCameraChange={(event) => event.detail.source === 'pointer'}
    onLightChange={({ detail }) => detail.lights.length}
    onLoad={({ detail }) => detail.url}
    onError={({ detail }) => detail.code}
    onProgress={({ detail }) => detail.totalProgress}
    onRender={() => same}
    onClick={(event) => event.clientX}
  >
    text <PhongLight position={[1, 2, 3]} active={false} diffuse={new Uint8Array(3)} space="camera" aperture={undefined} />
  </PhongViewer>,
  <PhongCompare at={[25, 50]} layout="side" onDividerChange={({ detail }) => detail.at}>
    <PhongViewer helpers="lights" view="normals" probe probeAt={[0, 0, 1]} onProbeChange={({ detail }) => detail.pinned} />
  </PhongCompare>,
  <PhongMesh scale={2} rotation="0 10 0" ka={128} onLoad={(event) => event.detail.url} auto-focus />,
];
export const unknown = [
  // @ts-expect-error there is no such value
  <PhongLight strength={2} />,
  // @ts-expect-error the event is another one
  <PhongViewer onCameraChange={(event: MouseEvent) => event} />,
  // @ts-expect-error there is no such layout
  <PhongCompare layout="grid" />,
  // @ts-expect-error a mesh has no camera
  <PhongMesh onCameraChange={() => undefined} />,
  // @ts-expect-error the ref is another element
  <PhongViewer ref={createRef<HTMLInputElement>()} />,
];
`;

test.describe('the packed tarball in a fresh React project @release', () => {
  const react = ['react@^19', 'react-dom@^19', '@types/react', '@types/react-dom@^19'];
  const project = useFreshProject(['three', '@types/three', 'typescript', 'vite', ...react], ({ write }) => {
    write('app.tsx', app);
    write('refusals.tsx', refusals);
    write('components.tsx', components);
    write('readme.jsx', readmeSample('React, Next'));
    const compilerOptions = { ...strictOptions, jsx: 'react-jsx', allowJs: true, checkJs: true };
    const files = ['app.tsx', 'refusals.tsx', 'components.tsx', 'readme.jsx'];
    write('tsconfig.json', JSON.stringify({ compilerOptions, files }));
  });

  test('accepts valid JSX props and rejects invalid ones', () => {
    project().run('npx tsc -p .');
  });

  test('draws, follows state and dispatches events', async ({ page }) => {
    const body = '<div id="root"></div><script type="module" src="./app.tsx"></script>';
    await project().open(page, project().build(body));
    const viewer = page.locator('phong-viewer');
    const middle = async (): Promise<readonly number[]> => {
      await allReady(page);
      return pixelAt(await pixels(viewer, { width: 64, height: 64 }), 32, 32);
    };
    expect(await middle()).toEqual([200, 0, 0, 255]);
    for (const [button, color] of [
      ['add', [200, 0, 200, 255]],
      ['remove', [0, 0, 200, 255]],
      ['dim', [0, 0, 0, 255]],
    ] as const) {
      await page.getByText(button).click();
      expect(await middle(), button).toEqual(color);
    }

    const { x, y } = (await viewer.boundingBox())!;
    await page.mouse.move(x + 200, y + 100);
    await page.mouse.down();
    await page.mouse.move(x + 170, y + 100);
    await page.mouse.up();
    await expect(page.locator('output')).toHaveText('pointer 36');
  });
});
