import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  ColorManagement,
  DirectionalLight,
  DoubleSide,
  LinearSRGBColorSpace,
  LineBasicMaterial,
  LineSegments,
  Mesh as ThreeMesh,
  MeshLambertMaterial,
  OrthographicCamera,
  Scene,
  Spherical,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { colourOf } from "./colours.js";

/** From where a view looks, LPS: +x Left, +y Posterior, +z Superior. */
const directions = {
  R: [-1, 0, 0],
  L: [1, 0, 0],
  A: [0, -1, 0],
  P: [0, 1, 0],
  S: [0, -0.001, 1],
  I: [0, -0.001, -1],
};
const turnStep = Math.PI / 24;
const zoomStep = 1.15;

/** The picture of a mesh. Drawn when something changed, not all the time. */
export class MeshScene {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {HTMLElement} letters  where the letters of the directions go
   * @param {import("./mesh.js").Mesh} mesh
   * @throws where there is no WebGL
   */
  constructor(canvas, letters, mesh) {
    ColorManagement.enabled = false;
    this.canvas = canvas;
    this.mesh = mesh;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.findExtent();
    this.makeCamera();
    this.makeObjects();
    this.makeLetters(letters);
    canvas.addEventListener("keydown", (event) => this.onKey(event));
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  findExtent() {
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = low.clone().negate();
    const point = new Vector3();
    for (let at = 0; at < this.mesh.positions.length; at += 3) {
      point.fromArray(this.mesh.positions, at);
      low.min(point);
      high.max(point);
    }
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.radius = low.distanceTo(high) / 2;
    this.extent = high.clone().sub(low);
  }

  makeCamera() {
    this.camera = new OrthographicCamera(-1, 1, 1, -1, 0, 8 * this.radius);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.target.copy(this.centre);
    this.controls.addEventListener("change", () => this.draw());
    this.place(new Vector3(-0.5, -1, 0.45));
  }

  makeObjects() {
    this.scene = new Scene();
    this.geometry = new BufferGeometry();
    this.edgeGeometry = new BufferGeometry();
    const surface = new MeshLambertMaterial({
      vertexColors: true,
      flatShading: true,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.edges = new LineSegments(this.edgeGeometry, new LineBasicMaterial({ color: 0x1c2330 }));
    this.lamp = new DirectionalLight(0xffffff, 1.4);
    this.scene.add(new ThreeMesh(this.geometry, surface), this.edges, new AmbientLight(0xffffff, 1.9));
    this.scene.add(this.lamp, this.lamp.target);
    this.lamp.target.position.copy(this.centre);
  }

  makeLetters(parent) {
    this.letters = Object.keys(directions).map((name) => {
      const span = document.createElement("span");
      span.textContent = name;
      parent.append(span);
      const [x, y, z] = directions[name].map(Math.round);
      const reach = (Math.abs(x) * this.extent.x + Math.abs(y) * this.extent.y + Math.abs(z) * this.extent.z) / 2;
      return { span, direction: new Vector3(x, y, z).setLength(reach + 0.14 * this.radius) };
    });
  }

  /** @param {Vector3} direction  from the middle to the eye */
  place(direction) {
    this.camera.position.copy(direction).setLength(4 * this.radius).add(this.centre);
    this.camera.lookAt(this.centre);
    this.controls.update();
  }

  /** @param {string} name  R, L, A, P, S or I */
  lookFrom(name) {
    this.place(new Vector3(...directions[name]));
    this.draw();
  }

  onKey(event) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (turns[event.key]) {
      this.turn(...turns[event.key]);
    } else if (event.key === "+" || event.key === "=") {
      this.zoom(zoomStep);
    } else if (event.key === "-") {
      this.zoom(1 / zoomStep);
    } else {
      return;
    }
    event.preventDefault();
  }

  turn(sideways, upwards) {
    const toEye = this.camera.position.clone().sub(this.centre);
    const spherical = new Spherical().setFromVector3(new Vector3(toEye.x, toEye.z, -toEye.y));
    spherical.theta += sideways * turnStep;
    spherical.phi += upwards * turnStep;
    spherical.makeSafe();
    const turned = new Vector3().setFromSpherical(spherical);
    this.place(new Vector3(turned.x, -turned.z, turned.y));
    this.draw();
  }

  zoom(factor) {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, 0.2), 40);
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) {
      return;
    }
    this.renderer.setSize(clientWidth, clientHeight, false);
    const half = 0.95 * this.radius;
    const [x, y] = clientWidth > clientHeight ? [clientWidth / clientHeight, 1] : [1, clientHeight / clientWidth];
    Object.assign(this.camera, { left: -half * x, right: half * x, top: half * y, bottom: -half * y });
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /**
   * Shows cells in the colours of a field.
   * @param {Uint8Array} seen  1 for each cell that is seen
   * @param {{values: Float32Array, low: number, high: number}} field
   */
  show(seen, field) {
    const positions = [];
    const colours = [];
    const triangles = [];
    const lines = [];
    for (const { corners, cell } of this.mesh.seenFaces(seen)) {
      const first = positions.length / 3;
      const colour = colourOf((field.values[cell] - field.low) / (field.high - field.low || 1));
      for (const node of corners) {
        positions.push(...this.mesh.positions.subarray(3 * node, 3 * node + 3));
        colours.push(...colour);
      }
      triangles.push(first, first + 1, first + 2, first, first + 2, first + 3);
      lines.push(first, first + 1, first + 1, first + 2, first + 2, first + 3, first + 3, first);
    }
    const points = new BufferAttribute(new Float32Array(positions), 3);
    for (const [geometry, index] of [
      [this.geometry, triangles],
      [this.edgeGeometry, lines],
    ]) {
      geometry.dispose();
      geometry.setAttribute("position", points);
      geometry.setIndex(index);
      geometry.computeBoundingSphere();
    }
    this.geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 3));
    this.draw();
  }

  draw() {
    if (!this.scene) {
      return;
    }
    this.lamp.position.copy(this.camera.position).add(new Vector3(0, 0, this.radius));
    this.renderer.render(this.scene, this.camera);
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    const toEye = this.camera.position.clone().sub(this.centre);
    for (const { span, direction } of this.letters) {
      const place = direction.clone().add(this.centre).project(this.camera);
      const [x, y] = [((place.x + 1) / 2) * clientWidth, ((1 - place.y) / 2) * clientHeight];
      span.classList.toggle("behind", direction.dot(toEye) < 0);
      span.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
    }
  }
}
